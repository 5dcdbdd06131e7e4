package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Deformation;
import org.palpate.scene.DeformationColour;
import org.palpate.scene.DeformationColour.Measure;
import org.palpate.scene.GreySlices;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SlicePlanes;
import org.palpate.scene.StandardView;
import org.palpate.scene.Theme;
import org.palpate.scene.TouchMarks;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.gl.PickedPoint;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** Compares pictures of deformed scenes with rigid ones and with a plain interpolation. */
class DeformedSceneWindowTest {
  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;
  private static final int EDGE = 24;
  private static final int NODES = 6;
  private static final Vec3 ORIGIN_MM = new Vec3(-8, -8, -8);
  private static final double CELL_MM = 8;
  private static final double FRONT_MM = 8;

  private OffscreenRenderer scene;

  @BeforeEach
  void open() throws GraphicsException {
    TestDisplay.require();
    scene = new OffscreenRenderer(WIDTH, HEIGHT, 1);
  }

  @AfterEach
  void close() {
    if (scene != null) {
      scene.close();
    }
  }

  /** The displacement of a node at a position, grid mm. */
  private interface Field {
    Vec3 at(Vec3 restMm);
  }

  private static Deformation deformation(Field field) {
    float[] mm = new float[3 * NODES * NODES * NODES];
    for (int node = 0; node < NODES * NODES * NODES; node++) {
      Vec3 u = field.at(position(node % NODES, node / NODES % NODES, node / NODES / NODES));
      mm[3 * node] = (float) u.x;
      mm[3 * node + 1] = (float) u.y;
      mm[3 * node + 2] = (float) u.z;
    }
    int[] nodes = {NODES, NODES, NODES};
    return new Deformation(nodes, ORIGIN_MM, new Vec3(CELL_MM, CELL_MM, CELL_MM), mm);
  }

  /** Returns a deformation with short cells from the second to the last but one node. */
  private static Deformation windowed(Field outside, Field inside) {
    int nodes = 2 * (NODES - 3) + 1;
    double shortMm = CELL_MM / 2;
    Vec3 origin = position(1, 1, 1);
    float[] mm = new float[3 * nodes * nodes * nodes];
    for (int node = 0; node < mm.length / 3; node++) {
      int layer = node / nodes / nodes;
      Vec3 rest = new Vec3(node % nodes, node / nodes % nodes, layer).mul(shortMm, new Vec3());
      rest.add(origin, rest);
      Vec3 u = inside.at(rest);
      mm[3 * node] = (float) u.x;
      mm[3 * node + 1] = (float) u.y;
      mm[3 * node + 2] = (float) u.z;
    }
    Deformation whole = deformation(outside);
    Deformation window =
        new Deformation(
            new int[] {nodes, nodes, nodes}, origin, new Vec3(shortMm, shortMm, shortMm), mm);
    return new Deformation(
        new int[] {NODES, NODES, NODES},
        ORIGIN_MM,
        new Vec3(CELL_MM, CELL_MM, CELL_MM),
        whole.displacementsMm(),
        Optional.of(window));
  }

  /** The box lies in the window, where the lattice would move it far away. */
  @Test
  void inAWindowItsOwnCellsAreDrawn() throws Exception {
    Field bend = rest -> new Vec3(0, 0.02 * (rest.x - 12) * (rest.x - 12), 0);
    SceneModel model = model(RigidTransform.identity(), false);
    picture(model, Optional.empty());
    model.setMarks(Optional.empty(), Optional.of(windowed(rest -> new Vec3(40, 0, 0), bend)));
    scene.draw(model.state());
    int found = 0;
    for (int x = 100; x < 220; x += 5) {
      for (int y = 60; y < 180; y += 5) {
        Optional<PickedPoint> picked = scene.pick(model.state(), x, y);
        if (picked.isPresent() && Math.abs(picked.get().surfaceMm().x - 12) < 7) {
          Vec3 seen = picked.get().surfaceMm();
          double at = (seen.x + 8) / 4;
          double part = at - Math.floor(at);
          double low = 4 * Math.floor(at) - 20;
          double bent = 0.02 * ((1 - part) * low * low + part * (low + 4) * (low + 4));
          assertEquals(FRONT_MM + bent, seen.y, 0.12, "at " + seen);
          assertEquals(FRONT_MM, model.state().atRest(seen).y, 0.15);
          found++;
        }
      }
    }
    assertTrue(found > 200, "found " + found);
  }

  private static Vec3 position(int i, int j, int k) {
    return new Vec3(CELL_MM * i, CELL_MM * j, CELL_MM * k).add(ORIGIN_MM, new Vec3());
  }

  @Test
  void aRotationByTheFieldLooksLikeARotationByThePose() throws Exception {
    RigidTransform turn = turn(0.3);
    Field field = rest -> turn.transform(rest, new Vec3()).sub(rest, new Vec3());
    SceneModel rigid = model(turn, false);
    SceneModel elastic = model(RigidTransform.identity(), false);
    Picture still = picture(elastic, Optional.empty());
    rigid.moveCamera(camera -> elastic.camera(), false);
    Picture turned = scene.draw(rigid.state());
    Picture deformed = picture(elastic, Optional.of(field));
    int apart = differing(still, turned);
    int wrong = differing(deformed, turned);
    assertTrue(apart > 1000, "the rotation is visible: " + apart);
    assertTrue(wrong < apart / 50, wrong + " of " + apart + " pixels differ");
  }

  private static RigidTransform turn(double radians) {
    double c = Math.cos(radians);
    double s = Math.sin(radians);
    Vec3 middle = new Vec3(12, 12, 12);
    Vec3 origin = new Vec3(12 - 12 * c + 12 * s, 12 - 12 * s - 12 * c, 0);
    RigidTransform turn =
        new RigidTransform(new Vec3(c, s, 0), new Vec3(-s, c, 0), new Vec3(0, 0, 1), origin);
    assertTrue(turn.transform(middle, new Vec3()).sub(middle, new Vec3()).length() < 1e-9);
    return turn;
  }

  /** A shear of x by y leaves the normal of the front, which looks along y, as it is. */
  @Test
  void aShearAlongAFaceLeavesItsShadeAsItIs() throws Exception {
    Field shear = rest -> new Vec3(0.5 * (rest.y - FRONT_MM), 0, 0);
    Picture still = picture(model(RigidTransform.identity(), false), Optional.empty());
    Picture sheared = picture(model(RigidTransform.identity(), false), Optional.of(shear));
    int rgb = still.rgb(WIDTH / 2, HEIGHT / 2);
    assertEquals(rgb, sheared.rgb(WIDTH / 2, HEIGHT / 2), Integer.toHexString(rgb));
  }

  @Test
  void theSurfaceIsAffineOnTheTetrahedraOfEachCell() throws Exception {
    SplittableRandom random = new SplittableRandom(5);
    double[] depth = new double[NODES * NODES * NODES];
    for (int n = 0; n < depth.length; n++) {
      depth[n] = 2 * random.nextDouble();
    }
    Field field =
        rest -> {
          Vec3 at = rest.sub(ORIGIN_MM, new Vec3()).mul(1 / CELL_MM, new Vec3());
          int node = (int) at.x + NODES * ((int) at.y + NODES * (int) at.z);
          return new Vec3(0, depth[node], 0);
        };
    SceneModel model = model(RigidTransform.identity(), false);
    picture(model, Optional.of(field));
    int found = 0;
    for (int x = 100; x < 220; x += 5) {
      for (int y = 60; y < 180; y += 5) {
        Optional<PickedPoint> picked = scene.pick(model.state(), x, y);
        if (picked.isPresent()) {
          Vec3 seen = picked.get().surfaceMm();
          boolean inFront = seen.x > 5 && seen.x < 19 && seen.z > 5 && seen.z < 19;
          if (inFront) {
            double expected = FRONT_MM + interpolated(depth, seen.x, FRONT_MM, seen.z);
            assertEquals(expected, seen.y, 0.12, "at " + seen);
            Vec3 rest = model.state().atRest(seen);
            assertEquals(FRONT_MM, rest.y, 0.15, "at rest " + rest);
            assertEquals(seen.x, rest.x, 0.01, "at rest " + rest);
            found++;
          }
        }
      }
    }
    assertTrue(found > 200, "found " + found);
  }

  /** Walks from the first node of the cell along the axes, the longest way first. */
  private static double interpolated(double[] values, double... restMm) {
    int[] cell = new int[3];
    double[] part = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      double at = (restMm[axis] - ORIGIN_MM.get(axis)) / CELL_MM;
      cell[axis] = (int) Math.floor(at);
      part[axis] = at - cell[axis];
    }
    List<Integer> order =
        List.of(0, 1, 2).stream().sorted((a, b) -> Double.compare(part[b], part[a])).toList();
    double sum = (1 - part[order.get(0)]) * values[node(cell)];
    for (int n = 0; n < 3; n++) {
      cell[order.get(n)]++;
      double rest = n < 2 ? part[order.get(n + 1)] : 0;
      sum += (part[order.get(n)] - rest) * values[node(cell)];
    }
    return sum;
  }

  private static int node(int[] index) {
    return index[0] + NODES * (index[1] + NODES * index[2]);
  }

  private Picture coloured(Optional<DeformationColour> by, Field field) throws Exception {
    SceneModel model = model(RigidTransform.identity(), false);
    by.ifPresent(colour -> model.changeLook(look -> look.with(colour)));
    return picture(model, Optional.of(field));
  }

  @Test
  void motionsWithoutStrainLeaveTheColourAsItIs() throws Exception {
    Optional<DeformationColour> strain = Optional.of(new DeformationColour(Measure.STRAIN, 0.1));
    RigidTransform turn = turn(0.3);
    Field turned = rest -> turn.transform(rest, new Vec3()).sub(rest, new Vec3());
    assertEquals(0, differing(coloured(Optional.empty(), turned), coloured(strain, turned)));
  }

  /** Two deformations that leave the front where it looks, with the same equivalent strain. */
  @Test
  void strainIsTheEquivalentStrainOfGreensTensor() throws Exception {
    double shear = 0.4;
    double exy = shear / 2;
    double eyy = shear * shear / 2;
    double equivalent = Math.sqrt(2.0 / 3 * (2.0 / 3 * eyy * eyy + 2 * exy * exy));
    double stretch = Math.sqrt(1 + 3 * equivalent) - 1; // Green's strain is 1.5 times it, along x.
    for (double most : new double[] {1.2 * equivalent, 2 * equivalent, 4 * equivalent}) {
      Optional<DeformationColour> by = Optional.of(new DeformationColour(Measure.STRAIN, most));
      int sheared =
          coloured(by, rest -> new Vec3(shear * (rest.y - FRONT_MM), 0, 0))
              .rgb(WIDTH / 2, HEIGHT / 2);
      int stretched =
          coloured(by, rest -> new Vec3(stretch * (rest.x - 12), 0, 0)).rgb(WIDTH / 2, HEIGHT / 2);
      assertTrue(
          isNear(sheared, stretched),
          Integer.toHexString(sheared) + " and " + Integer.toHexString(stretched));
      Optional<DeformationColour> other =
          Optional.of(new DeformationColour(Measure.STRAIN, 1.3 * most));
      int less =
          coloured(other, rest -> new Vec3(stretch * (rest.x - 12), 0, 0))
              .rgb(WIDTH / 2, HEIGHT / 2);
      assertTrue(!isNear(less, stretched), "the scale counts: " + Integer.toHexString(less));
    }
  }

  @Test
  void aDisplacementIsColouredByItsLength() throws Exception {
    Optional<DeformationColour> by = Optional.of(new DeformationColour(Measure.DISPLACEMENT, 3));
    int along = coloured(by, rest -> new Vec3(2, 0, 0)).rgb(WIDTH / 2, HEIGHT / 2);
    int aslant = coloured(by, rest -> new Vec3(-1.2, 0, 1.6)).rgb(WIDTH / 2, HEIGHT / 2);
    int longer = coloured(by, rest -> new Vec3(2.9, 0, 0)).rgb(WIDTH / 2, HEIGHT / 2);
    assertTrue(isNear(along, aslant), Integer.toHexString(along) + Integer.toHexString(aslant));
    assertTrue((along >> 8 & 255) > (along >> 16 & 255), "green: " + Integer.toHexString(along));
    assertTrue((longer >> 16 & 255) > 150, "yellow: " + Integer.toHexString(longer));
    assertTrue((longer & 255) < 120, "yellow: " + Integer.toHexString(longer));
  }

  @Test
  void slicesAreDeformedToo() throws Exception {
    SceneModel model = model(RigidTransform.identity(), true);
    Picture still = picture(model, Optional.empty());
    Picture lifted = picture(model, Optional.of(rest -> new Vec3(0, 0, 6)));
    assertTrue(isBright(still.rgb(WIDTH / 2, HEIGHT / 2)), "the middle is bright");
    int top = 0;
    while (!isBright(still.rgb(WIDTH / 2, top))) {
      top++;
    }
    assertTrue(isBright(lifted.rgb(WIDTH / 2, top - 10)), "the slice is lifted");
    assertTrue(!isBright(still.rgb(WIDTH / 2, top - 10)), "and was not there before");
  }

  private static boolean isBright(int rgb) {
    return (rgb & 255) > 150;
  }

  @Test
  void nothingIsCulledThatTheFieldMovesIntoView() throws Exception {
    SceneModel model = model(RigidTransform.identity(), false);
    model.look(StandardView.FRONT, (double) WIDTH / HEIGHT);
    // The camera looks beside the box, and the field brings the box before it.
    model.moveCamera(camera -> camera.zoom(0.2), false);
    Deformation far = deformation(rest -> new Vec3(60, 0, 0));
    model.setMarks(Optional.empty(), Optional.of(far));
    Picture away = scene.draw(model.state());
    model.setMarks(Optional.empty(), Optional.of(deformation(rest -> new Vec3(0, 0, 0))));
    Picture still = scene.draw(model.state());
    assertTrue(differing(away, still) > WIDTH * HEIGHT / 3, "the box fills the picture at rest");
  }

  private Picture picture(SceneModel model, Optional<Field> field) throws Exception {
    model.look(StandardView.FRONT, (double) WIDTH / HEIGHT);
    model.setMarks(Optional.<TouchMarks>empty(), field.map(DeformedSceneWindowTest::deformation));
    return scene.draw(model.state());
  }

  private static int differing(Picture a, Picture b) {
    int count = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        count += isNear(a.rgb(x, y), b.rgb(x, y)) ? 0 : 1;
      }
    }
    return count;
  }

  private static boolean isNear(int a, int b) {
    boolean near = true;
    for (int shift = 0; shift <= 16; shift += 8) {
      near &= Math.abs((a >> shift & 255) - (b >> shift & 255)) <= 6;
    }
    return near;
  }

  /** Returns a box; with slices alone a bright plane instead. */
  private static SceneModel model(RigidTransform pose, boolean slices) throws Exception {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 4; k < 20; k++) {
      for (int j = (int) FRONT_MM; j < 16; j++) {
        for (int i = 4; i < 20; i++) {
          bits.set(i, j, k);
        }
      }
    }
    VoxelGrid grid = new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(1, 1, 1), pose);
    SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
    List<Segment> segments = List.of(new Segment("box", bits, 0xd0b090));
    try (SceneLoader loader = new SceneLoader(model, new SegmentedVolume(grid, segments), 1)) {
      loader.await(60_000);
    }
    if (slices) {
      model.objects().forEach(object -> model.setVisible(object, false));
      ScalarVolume values = ScalarVolume.of(grid, ScalarVolume.Storage.UINT8);
      for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
        int k = n / EDGE / EDGE;
        values.set(n % EDGE, n / EDGE % EDGE, k, k > 3 && k < 20 ? 200 : 20);
      }
      SlicePlanes planes = new GreySlices(values).through(-1, EDGE / 2, -1, model);
      model.changeLook(look -> look.with(Optional.of(planes)));
    }
    return model;
  }
}
