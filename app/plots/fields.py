"""Reads the fields a run has written: frames(directory, name) of DIR/NAME.xdmf.

A frame has time (s), points (n x 3, m), cells (m x nodes, or None for particles) and
field(name), by the full name "pressure [Pa]" or without its unit. Data are read when asked for.
"""
import os
import xml.etree.ElementTree as xml

import h5py


class Frame:
    def __init__(self, directory, grid):
        self.directory = directory
        self.time = float(grid.find("Time").get("Value"))
        self._points = grid.find("Geometry/DataItem")
        self._cells = None if grid.find("Topology").get("TopologyType") == "Polyvertex" else grid.find("Topology/DataItem")
        self._fields = {a.get("Name"): a.find("DataItem") for a in grid.findall("Attribute")}

    def _read(self, item):
        name, key = item.text.strip().split(":", 1)
        with h5py.File(os.path.join(self.directory, name), "r") as file:
            return file[key][()]

    @property
    def points(self):
        return self._read(self._points)

    @property
    def cells(self):
        return None if self._cells is None else self._read(self._cells)

    @property
    def names(self):
        return list(self._fields)

    def field(self, name):
        for full in self._fields:
            if full == name or full.split(" [")[0] == name:
                return self._read(self._fields[full])
        raise KeyError(f"There is no field {name}; there are {', '.join(self._fields)}.")


def frames(directory, name):
    root = xml.parse(os.path.join(directory, name + ".xdmf")).getroot()
    return [Frame(directory, grid) for grid in root.find("Domain").find("Grid").findall("Grid")]
