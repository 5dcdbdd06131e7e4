package org.palpate.volume.phantom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;

class PhantomTest {

  @Test
  void readsNameEdgeAndGrey() {
    assertEquals("head:256", Phantom.parse("head").spec());
    assertEquals("torus:192:grey", Phantom.parse("torus:192:grey").spec());
    assertEquals("maze:256:grey", Phantom.parse("maze:grey").spec());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "Head", "cube", "head:", "head:3", "head:x", "head:9999", "head:64:64"})
  void refusesAnUnknownSpec(String spec) {
    assertThrows(IllegalArgumentException.class, () -> Phantom.parse(spec));
  }

  @ParameterizedTest
  @ValueSource(strings = {"sphere:40", "plane:33", "torus:64"})
  void fillsTheVoxelsWhoseCentresLieInside(String spec) {
    Phantom phantom = Phantom.parse(spec);
    BitCube bits = onlySegment(phantom);
    AnalyticSurface surface = phantom.analyticSurface().orElseThrow();
    Vec3 centre = new Vec3();
    for (int k = 0; k < phantom.edge(); k++) {
      for (int j = 0; j < phantom.edge(); j++) {
        for (int i = 0; i < phantom.edge(); i++) {
          centre.set(i + 0.5, j + 0.5, k + 0.5);
          assertEquals(surface.signedDistance(centre) <= 0, bits.get(i, j, k), () -> "" + centre);
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"sphere:40", "plane:33", "torus:64", "shell:40"})
  void normalOfTheSurfaceIsTheGradientOfItsDistance(String spec) {
    AnalyticSurface surface = Phantom.parse(spec).analyticSurface().orElseThrow();
    double step = 1e-4;
    Vec3 point = new Vec3(31.3, 12.7, 22.9);
    Vec3 normal = surface.normal(point, new Vec3());
    for (int axis = 0; axis < 3; axis++) {
      Vec3 there = new Vec3().set(point);
      there.set(axis, point.get(axis) + step);
      double slope = (surface.signedDistance(there) - surface.signedDistance(point)) / step;
      assertEquals(normal.get(axis), slope, 1e-3);
    }
  }

  @ParameterizedTest
  @EnumSource(Phantom.Kind.class)
  void labelsEqualThoseOfTheNaivePhantom(Phantom.Kind kind) {
    int edge = 35; // not a multiple of a brick: padding must stay clear
    Phantom phantom = new Phantom(kind, edge, false, 5);
    SegmentedVolume volume = phantom.segments();
    short[] slice = new short[edge * edge];
    PhantomSlices slices = phantom.slices();
    for (int k = 0; k < edge; k++) {
      slices.read(k, slice);
      for (int n = 0; n < slice.length; n++) {
        int i = n % edge;
        int j = n / edge;
        assertEquals(NaivePhantom.label(phantom, i, j, k), slice[n], () -> kind + " label");
        for (int label = 1; label <= volume.segments().size(); label++) {
          boolean solid = volume.segments().get(label - 1).bits().get(i, j, k);
          assertEquals(slice[n] == label, solid, () -> kind + " bit");
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Phantom.Kind.class)
  void greyValuesEqualThoseOfTheNaivePhantom(Phantom.Kind kind) {
    int edge = 22;
    Phantom phantom = new Phantom(kind, edge, true, 5);
    short[] slice = new short[edge * edge];
    PhantomSlices slices = phantom.slices();
    for (int k = edge - 1; k >= 0; k--) {
      slices.read(k, slice);
      for (int n = 0; n < slice.length; n++) {
        assertEquals(NaivePhantom.grey(phantom, n % edge, n / edge, k), slice[n], kind.name());
      }
    }
  }

  @Test
  void greyValuesOfABallSumUpToItsVolume() {
    Phantom phantom = Phantom.parse("sphere:64:grey");
    double radius = 63.6 / 192 * 64;
    double sum = 0;
    short[] slice = new short[64 * 64];
    PhantomSlices slices = phantom.slices();
    for (int k = 0; k < 64; k++) {
      slices.read(k, slice);
      for (short value : slice) {
        sum += value;
      }
    }
    double volume = 4.0 / 3.0 * Math.PI * radius * radius * radius;
    assertEquals(1, sum / Phantom.SOLID_GREY / volume, 2e-4);
  }

  @ParameterizedTest
  @ValueSource(strings = {"shell:48", "shell:48:grey"})
  void shellIsClosed(String spec) {
    BitCube bits = thresholded(Phantom.parse(spec), Phantom.HALF_GREY);
    BitCube outside = FloodFill.throughFaces(bits, 0, 0, 0);
    assertFalse(outside.get(24, 24, 24));
  }

  @Test
  void shellIsOneVoxelThick() {
    BitCube bits = onlySegment(Phantom.parse("shell:48"));
    BitCube outside = FloodFill.throughFaces(bits, 0, 0, 0);
    long inner = FloodFill.throughFaces(bits, 24, 24, 24).solidCount();
    assertEquals(48L * 48 * 48, bits.solidCount() + outside.solidCount() + inner);
    FloodFill.forEachSolid(
        bits,
        (i, j, k) -> assertTrue(FloodFill.hasFaceNeighbour(outside, i, j, k), "an outer voxel"));
  }

  @Test
  void skinSeparatesTheBonesFromTheOutside() {
    SegmentedVolume head = Phantom.parse("head:64").segments();
    BitCube skull = head.segments().get(0).bits();
    BitCube jaw = head.segments().get(1).bits();
    BitCube skin = head.segments().get(2).bits();
    BitCube outside = FloodFill.throughFaces(skin, 0, 0, 0);
    FloodFill.forEachSolid(skull, (i, j, k) -> assertFalse(outside.get(i, j, k)));
    FloodFill.forEachSolid(jaw, (i, j, k) -> assertFalse(outside.get(i, j, k)));
    assertTrue(skull.solidCount() > 0 && jaw.solidCount() > 0);
  }

  @Test
  void jawTouchesNothingOfTheSkull() {
    SegmentedVolume head = Phantom.parse("head:128").segments();
    BitCube skull = head.segments().get(0).bits();
    FloodFill.forEachSolid(
        head.segments().get(1).bits(),
        (i, j, k) -> assertFalse(FloodFill.hasNeighbour(skull, i, j, k), "jaw beside skull"));
  }

  @Test
  void wallsOfOneVoxelCloseTheSinuses() {
    BitCube skull = Phantom.parse("head:128").segments().segments().get(0).bits();
    BitCube maxillary = FloodFill.throughFaces(skull, 78, 29, 43);
    BitCube frontal = FloodFill.throughFaces(skull, 69, 24, 76);
    BitCube outside = FloodFill.throughFaces(skull, 0, 0, 0);
    assertTrue(maxillary.solidCount() > 500 && maxillary.solidCount() < 6000, "maxillary sinus");
    assertTrue(frontal.solidCount() > 50 && frontal.solidCount() < 1500, "frontal sinus");
    assertTrue(outside.get(64, 70, 76), "the cranium is open by its foramen");
    assertTrue(outside.get(78, 20, 60), "the orbit is open");
    long thin = FloodFill.countThinBetween(skull, maxillary, outside);
    assertTrue(thin > 100, "one-voxel walls of a maxillary sinus: " + thin);
  }

  @Test
  void mazeWallsShareEdgesAndCornersButNoFace() {
    BitCube maze = onlySegment(Phantom.parse("maze:64"));
    long[] edges = new long[1];
    FloodFill.forEachSolid(
        maze,
        (i, j, k) -> {
          assertFalse(FloodFill.hasFaceNeighbour(maze, i, j, k));
          edges[0] += FloodFill.hasNeighbour(maze, i, j, k) ? 1 : 0;
        });
    assertTrue(edges[0] > 0.99 * maze.solidCount(), "nearly every voxel has a neighbour");
  }

  @Test
  void mazeHasRoomsAndDoors() {
    BitCube maze = onlySegment(Phantom.parse("maze:96"));
    long free = 96L * 96 * 96 - maze.solidCount();
    long reached = FloodFill.throughFaces(maze, 49, 50, 50).solidCount();
    assertTrue(reached > 0.5 * free, "doors connect rooms: " + reached + " of " + free);
    assertTrue(reached < free, "some rooms have no door");
  }

  @Test
  void anotherSeedIsAnotherMaze() {
    BitCube one = onlySegment(new Phantom(Phantom.Kind.MAZE, 64, false, 1));
    BitCube two = onlySegment(new Phantom(Phantom.Kind.MAZE, 64, false, 2));
    assertTrue(one.solidCount() != two.solidCount());
  }

  private static BitCube onlySegment(Phantom phantom) {
    return phantom.segments().segments().get(0).bits();
  }

  private static BitCube thresholded(Phantom phantom, int atLeast) {
    if (!phantom.grey()) {
      return onlySegment(phantom);
    }
    int edge = phantom.edge();
    BitCube bits = new BitCube(edge, edge, edge);
    short[] slice = new short[edge * edge];
    PhantomSlices slices = phantom.slices();
    for (int k = 0; k < edge; k++) {
      slices.read(k, slice);
      for (int n = 0; n < slice.length; n++) {
        if (slice[n] >= atLeast) {
          bits.set(n % edge, n / edge, k);
        }
      }
    }
    return bits;
  }
}
