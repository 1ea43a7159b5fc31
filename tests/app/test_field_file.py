"""Reads the XDMF and HDF5 files of test_field_file.cc back with independent readers (h5py, which brings the serial HDF5 and so is in
a process of its own, and meshio)."""
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

import h5py
import meshio
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
        subprocess.run([os.path.join(BUILD, "tests", "test_run"), "--run_test=field_file/frames_for_the_python_reader"],
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
        self.assertEqual(grid.find("Topology").get("NodesPerElement"), "1")
        np.testing.assert_array_equal(data(self.directory, grid.find("Topology/DataItem")), [[0], [1]])
        np.testing.assert_array_equal(data(self.directory, grid.find("Attribute/DataItem")), [1000, 1001])

    def read_with_meshio(self, name, step):
        with meshio.xdmf.TimeSeriesReader(os.path.join(self.directory, name + ".xdmf")) as reader:
            reader.mesh_grid = reader.collection[step]  # every frame has points of its own
            points, cells = reader.read_points_cells()
            return (reader.num_steps, points, cells) + reader.read_data(step)

    def test_meshio_reads_every_frame(self):
        for step, time in enumerate((0., 0.1, 0.25)):
            steps, points, (cells,), read_time, on_points, on_cells = self.read_with_meshio("mesh", step)
            self.assertEqual((steps, read_time), (3, time))
            np.testing.assert_array_equal(points[:, 0], [time, 1 + time, 2 + time] * 2)
            self.assertEqual(cells.type, "quad")
            np.testing.assert_array_equal(cells.data, [[0, 1, 4, 3], [1, 2, 5, 4]])
            np.testing.assert_array_equal(on_points["velocity [m/s]"], np.full((6, 3), time))
            np.testing.assert_array_equal(on_cells["pressure [Pa]"][0], [10 * time, -1])

    def test_meshio_reads_vertices(self):
        _, points, (cells,), time, on_points, _ = self.read_with_meshio("points", 0)
        self.assertEqual((time, cells.type), (1e-7, "vertex"))
        np.testing.assert_array_equal(points, [[0, 0, 0], [1, 2, 3]])
        np.testing.assert_array_equal(cells.data, [[0], [1]])
        np.testing.assert_array_equal(on_points["density [kg/m^3]"], [1000, 1001])

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
        self.assertIsNone(fields.frames(self.directory, "points")[0].cells)


if __name__ == "__main__":
    unittest.main()
