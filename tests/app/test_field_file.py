"""Reads the XDMF and HDF5 files of test_field_file.cc back with an independent reader (h5py,
in its own process: it brings the serial HDF5)."""
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

import h5py
import numpy as np

BUILD = os.environ["TURGOR_BUILD"]
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(SOURCE, "app", "plots"))
import fields  # noqa: E402


def data(directory, item):
    name, key = item.text.split(":")
    with h5py.File(os.path.join(directory, name), "r") as file:
        values = file[key][()]
    shape = tuple(int(n) for n in item.get("Dimensions").split())
    assert values.shape == shape, (values.shape, shape)
    return values


class FieldFileTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.directory = cls.temporary.name
        subprocess.run([os.path.join(BUILD, "tests", "test_app"), "--run_test=field_file/frames_for_the_python_reader"],
                       env={**os.environ, "TURGOR_FIELD_DIRECTORY": cls.directory}, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def grids(self, name):
        root = xml.parse(os.path.join(self.directory, name + ".xdmf")).getroot()
        return root.find("Domain").find("Grid").findall("Grid")

    def test_times(self):
        times = [float(grid.find("Time").get("Value")) for grid in self.grids("mesh")]
        self.assertEqual(times, [0., 0.1, 0.25])

    def test_mesh_and_fields(self):
        for grid in self.grids("mesh"):
            time = float(grid.find("Time").get("Value"))
            self.assertEqual(grid.find("Topology").get("TopologyType"), "Quadrilateral")
            np.testing.assert_array_equal(data(self.directory, grid.find("Topology/DataItem")), [[0, 1, 4, 3], [1, 2, 5, 4]])
            points = data(self.directory, grid.find("Geometry/DataItem"))
            np.testing.assert_array_equal(points[:, 0], [time, 1 + time, 2 + time] * 2)
            attributes = {a.get("Name"): a for a in grid.findall("Attribute")}
            self.assertEqual(list(attributes), ["pressure [Pa]", "velocity [m/s]", "velocity"])
            self.assertEqual(attributes["pressure [Pa]"].get("Center"), "Cell")
            self.assertEqual(attributes["velocity [m/s]"].get("AttributeType"), "Vector")
            np.testing.assert_array_equal(data(self.directory, attributes["pressure [Pa]"].find("DataItem")), [10 * time, -1])
            np.testing.assert_array_equal(data(self.directory, attributes["velocity [m/s]"].find("DataItem")),
                                          np.full((6, 3), time))
            np.testing.assert_array_equal(data(self.directory, attributes["velocity"].find("DataItem")), np.full(6, 0.5))

    def test_vertices(self):
        grid, = self.grids("points")
        self.assertEqual(grid.find("Topology").get("TopologyType"), "Polyvertex")
        self.assertEqual(grid.find("Topology").get("NumberOfElements"), "2")
        np.testing.assert_array_equal(data(self.directory, grid.find("Attribute/DataItem")), [1000, 1001])

    def test_names_and_time_in_the_hdf5_file(self):
        with h5py.File(os.path.join(self.directory, "points.frames", "000000.h5"), "r") as file:
            self.assertEqual(file.attrs["time"], 1e-7)
            self.assertEqual(file["density"].attrs["name"], b"density [kg/m^3]")

    def test_reader_of_the_plots(self):
        frames = fields.frames(self.directory, "mesh")
        self.assertEqual([frame.time for frame in frames], [0., 0.1, 0.25])
        self.assertEqual(frames[2].field("pressure")[0], 2.5)
        self.assertEqual(frames[1].points.shape, (6, 3))
        self.assertEqual(frames[1].cells.shape, (2, 4))


if __name__ == "__main__":
    unittest.main()
