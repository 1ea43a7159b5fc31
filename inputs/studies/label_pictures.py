"""Label images for studies: two of about 200 cells, written as PNG, and what mends them where the program refuses one.

  write_png("cells.png", holes_filled(pieces_joined(without_border_cells(ragged_picture()))))

Labels are integer arrays, 0 where there is no cell; row 0 is the lowest. The program's own cells come from label_image.py.
"""
import struct
import zlib

import numpy as np

PIXEL = 2e-6  # m
SIDES = ((1, 0), (-1, 0), (0, 1), (0, -1))


def write_png(path, labels):
    """Grey, 16 bits; row 0 of `labels` is the lowest."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows, columns = labels.shape
    pixels = np.hstack([np.zeros((rows, 1), np.uint8), np.ascontiguousarray(labels[::-1].astype(">u2")).view(np.uint8)])
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 16, 0, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(pixels.tobytes())) + chunk(b"IEND", b""))


def beside(labels, side):
    """Of every pixel the label on that side, 0 beyond the border."""
    padded = np.pad(labels, 1)
    return padded[1 + side[0]:padded.shape[0] - 1 + side[0], 1 + side[1]:padded.shape[1] - 1 + side[1]]


def hanging_together(allowed, start):
    """The pixels of `allowed` that hang together with those of `start` through their sides."""
    reached = start & allowed
    while True:
        more = reached.copy()
        for side in SIDES:
            more |= beside(reached, side) & allowed
        if (more == reached).all():
            return reached
        reached = more


# The two pictures


def drawn_picture(corners):
    """Labels with lines of a pixel, those without, and the polygons (m), of rows (cell, x, y)."""
    from matplotlib.path import Path
    corners = np.array(corners)
    corners[:, 1:] -= corners[:, 1:].min(axis=0) - 10 * PIXEL
    polygons = [corners[corners[:, 0] == cell, 1:] for cell in np.unique(corners[:, 0])]
    columns, rows = (np.ceil(corners[:, 1:].max(axis=0) / PIXEL) + 10).astype(int)
    whole = np.zeros((rows, columns), int)
    for label, polygon in enumerate(polygons, 1):
        low, high = (polygon.min(axis=0) / PIXEL).astype(int), (polygon.max(axis=0) / PIXEL).astype(int) + 1
        x, y = np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
        inside = Path(polygon).contains_points(PIXEL * np.column_stack([x.ravel() + 0.5, y.ravel() + 0.5])).reshape(x.shape)
        whole[y[inside], x[inside]] = label
    lined = whole.copy()
    for side in ((1, 0), (0, 1)):
        other = beside(whole, side)
        lined[(other != 0) & (other != whole)] = 0
    return lined, whole, polygons


def nearest(places, y, x):
    best, label = np.full(x.shape, np.inf), np.zeros(x.shape, int)
    for k, (u, v) in enumerate(places, 1):
        distance = (x - u) ** 2 + (y - v) ** 2
        closer = distance < best
        best[closer], label[closer] = distance[closer], k
    return label


def ragged_picture(side=800, cells=260):
    """Nearest places, read where noise displaces every pixel to; one cell missing, one with a hole."""
    random = np.random.default_rng(20)
    places = side * random.random((cells, 2))
    y, x = np.mgrid[2:side:4, 2:side:4]
    for _ in range(2):  # to the centroids
        label = nearest(places, y, x)
        places = np.array([[x[label == k].mean(), y[label == k].mean()] for k in range(1, cells + 1)])
    y, x = np.mgrid[0:side, 0:side].astype(float)
    waves = np.hypot(np.fft.fftfreq(side)[:, None], np.fft.fftfreq(side)[None, :])
    for axis in (x, y):
        smooth = np.fft.ifft2(np.fft.fft2(random.standard_normal((side, side))) * np.exp(-0.5 * (2 * np.pi * 4 * waves) ** 2)).real
        axis += 2.5 * smooth / smooth.std() + 0.5 * random.standard_normal((side, side))
    label = nearest(places, y, x)
    inner = np.argsort(np.hypot(*(places - side / 2).T)) + 1  # from the middle outwards
    label[label == inner[0]] = 0
    y, x = np.mgrid[0:side, 0:side]
    u, v = places[inner[12] - 1]
    label[np.hypot(x - u, y - v) < 8] = 0
    return label


# Mending: each does what one sentence of the program asks for


def without_border_cells(labels):
    rim = np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]])
    return np.where(np.isin(labels, rim), 0, labels)


def pieces_joined(labels):
    """Of every cell the piece with the pixel that is deepest in it stays, the others go to the cell beside them, or to space."""
    labels = labels.copy()
    for cell in np.unique(labels[labels > 0]):
        mine, box = box_of(labels, cell)
        core = mine
        while core.any():  # shrunk until nothing is left; what was last is deepest
            last, core = core, core & np.all([beside(core, side) for side in SIDES], axis=0)
        one = np.zeros_like(last)
        one.flat[np.flatnonzero(last)[0]] = True
        labels[box][mine & ~hanging_together(mine, one)] = -1
    while (labels < 0).any():
        before = labels.copy()
        for side in SIDES:
            other = beside(before, side)
            take = (labels < 0) & (other > 0)
            labels[take] = other[take]
        if (labels == before).all():
            labels[labels < 0] = 0  # amid space
    return labels


def holes_filled(labels):
    labels = labels.copy()
    for cell in np.unique(labels[labels > 0]):
        mine, box = box_of(labels, cell)
        rim = np.ones_like(mine)
        rim[1:-1, 1:-1] = False
        labels[box][~mine & ~hanging_together(~mine, rim)] = cell
    return labels


def box_of(labels, cell):
    """Which pixels are the cell's, within a box with a pixel to spare, and that box."""
    rows, columns = np.flatnonzero((labels == cell).any(axis=1)), np.flatnonzero((labels == cell).any(axis=0))
    box = tuple(slice(max(0, at[0] - 1), at[-1] + 2) for at in (rows, columns))
    return labels[box] == cell, box
