package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.device.HapticDevice;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.LegPath;
import org.palpate.raycast.Ray;
import org.palpate.recording.RecordingDevice;
import org.palpate.recording.SampleRecorder;
import org.palpate.recording.TrajectoryWriter;
import org.palpate.scene.window.PointerSpot;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.LegJudge;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** The mouse as a device: what is pressed is touched, from the side on which the user sees it. */
class MouseTouchTest {
  private static final int EDGE = 48;
  private static final int MIDDLE = EDGE / 2;
  private static final double DEPTH_MM = 3;
  private static final int FRAMES_A_PRESS = 500;

  /** Voxels of 0.5 x 0.5 x 1 mm in a world that is turned and moved. */
  private static final VoxelGrid GRID =
      new VoxelGrid(
          EDGE,
          EDGE,
          EDGE,
          new Vec3(0.5, 0.5, 1),
          new RigidTransform(
              new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(30, -20, 7)));

  private final BitCube bits = new BitCube(EDGE, EDGE, EDGE);
  private String hint = "none";
  private ContactScene scene;
  private MouseDevice mouse;
  private MouseTouch touch;
  private PointFrame frame;
  private LegJudge judge;
  private Vec3 lastDevice;
  private long nowNanos;

  @ParameterizedTest
  @EnumSource(
      value = SolverKind.class,
      names = {"SMOOTH", "GUARDED"})
  void aPressTouchesTheFrontFaceAndTheForcePointsAwayFromIt(SolverKind solver) {
    hollowBall();
    start(solver);
    Random random = new Random(Seeds.seed());
    for (int n = 0; n < 60; n++) {
      Vec3 eye = eye(random);
      Vec3 face = seen(eye, centreMm());
      // The drawn surface is true to about a voxel.
      Vec3 drawn = towards(face, eye, random.nextDouble() - 0.5);
      long freedBefore = frame.statistics().freed();
      assertTrue(touch.press(new PointerSpot(eye, drawn, DEPTH_MM, true)));
      runFrames(FRAMES_A_PRESS);
      String message = "press " + n + ", seed " + Seeds.seed();
      assertEquals(freedBefore + 1, frame.statistics().freed(), message);
      assertTrue(frame.point().contact, message);
      assertTrue(pointMm().sub(face, new Vec3()).length() < 2, message + ": " + pointMm());
      Vec3 away = eye.sub(face, new Vec3());
      double share = forceWorld().dot(away) / away.length() / forceWorld().length();
      assertTrue(share > 0.7, message + ": the force points away from the pressed face: " + share);
    }
  }

  @Test
  void aPressOfTheFarSideNeverLeadsALegThroughTheBall() {
    hollowBall();
    start(SolverKind.SMOOTH);
    Vec3 front = new Vec3(100, 0, 0).add(centreMm(), new Vec3());
    Vec3 back = new Vec3(-100, 0, 0).add(centreMm(), new Vec3());
    for (int n = 0; n < 6; n++) {
      Vec3 eye = n % 2 == 0 ? front : back;
      touch.press(new PointerSpot(eye, seen(eye, centreMm()), DEPTH_MM, true));
      runFrames(300);
      assertTrue(pointMm().sub(centreMm(), new Vec3()).x * (n % 2 == 0 ? 1 : -1) > 5);
    }
  }

  @Test
  void aDragGoesOnWithoutSettingThePointFree() {
    hollowBall();
    start(SolverKind.SMOOTH);
    Vec3 eye = new Vec3(150, 0, 150).add(centreMm(), new Vec3());
    for (int n = 0; n <= 40; n++) {
      Vec3 aim = new Vec3(-4 + 0.2 * n, 1, 0).add(centreMm(), new Vec3());
      assertTrue(touch.press(new PointerSpot(eye, seen(eye, aim), DEPTH_MM, n == 0)));
      runFrames(40);
    }
    runFrames(300);
    assertEquals(1, frame.statistics().freed());
    assertTrue(frame.point().contact);
    Vec3 aim = new Vec3(4, 1, 0).add(centreMm(), new Vec3());
    assertTrue(pointMm().sub(seen(eye, aim), new Vec3()).length() < 2);
  }

  @Test
  void aDragFromOneSurfaceToAnotherFarBehindItBeginsAnewThere() {
    ball(bits, new Vec3(MIDDLE - 12, MIDDLE, 40), 5);
    for (int j = 0; j < EDGE; j++) {
      for (int i = 0; i < EDGE; i++) {
        bits.set(i, j, 2);
      }
    }
    start(SolverKind.SMOOTH);
    Vec3 eye = new Vec3(0, 0, 300).add(centreMm(), new Vec3());
    Vec3 onBall = world(MIDDLE - 12, MIDDLE, 45);
    Vec3 onWall = world(MIDDLE - 2, MIDDLE, 3);
    touch.press(new PointerSpot(eye, seen(eye, onBall), DEPTH_MM, true));
    runFrames(300);
    touch.press(new PointerSpot(eye, seen(eye, onWall), DEPTH_MM, false));
    runFrames(300);
    assertEquals(2, frame.statistics().freed());
    assertTrue(frame.point().contact);
    assertTrue(pointMm().sub(seen(eye, onWall), new Vec3()).length() < 2, "" + pointMm());
  }

  @Test
  void aDragThatLeftTheSurfaceBeginsAnewWhereItComesBack() {
    hollowBall();
    start(SolverKind.GUARDED);
    Vec3 eye = new Vec3(0, 0, 200).add(centreMm(), new Vec3());
    Vec3 face = seen(eye, centreMm());
    Vec3 beside = new Vec3(60, 0, 0).add(face, new Vec3());
    assertTrue(touch.press(new PointerSpot(eye, face, DEPTH_MM, true)));
    runFrames(300);
    assertFalse(touch.press(new PointerSpot(eye, beside, DEPTH_MM, false)));
    runFrames(50);
    assertTrue(frame.point().contact, "the point stays while the mouse is beside the surface");
    assertTrue(touch.press(new PointerSpot(eye, face, DEPTH_MM, false)));
    runFrames(300);
    assertEquals(2, frame.statistics().freed());
  }

  @Test
  void theWheelPressesDeeperWithoutSettingThePointFree() {
    hollowBall();
    start(SolverKind.SMOOTH);
    Vec3 eye = new Vec3(90, 30, 20).add(centreMm(), new Vec3());
    Vec3 face = seen(eye, centreMm());
    touch.press(new PointerSpot(eye, face, 1, true));
    runFrames(FRAMES_A_PRESS);
    double light = frame.forceLengthNewton();
    touch.press(new PointerSpot(eye, face, 4, false));
    runFrames(FRAMES_A_PRESS);
    assertTrue(frame.forceLengthNewton() > 2 * light);
    assertEquals(1, frame.statistics().freed());
  }

  @Test
  void aPressOnTheBackgroundSaysSoAndMovesNothing() {
    hollowBall();
    start(SolverKind.SMOOTH);
    runFrames(10);
    Vec3 before = new Vec3().set(lastDevice);
    touch.pressedBackground();
    assertEquals(MouseTouch.NOTHING_THERE, hint);
    runFrames(10);
    assertTrue(before.sameBits(lastDevice));
    assertEquals(0, frame.statistics().freed());
  }

  @Test
  void aPictureWithoutASolidBehindItIsNothingToTouch() {
    hollowBall();
    start(SolverKind.SMOOTH);
    Vec3 eye = new Vec3(0, 0, 200).add(centreMm(), new Vec3());
    Vec3 onSlice = new Vec3(0, 0, 40).add(centreMm(), new Vec3());
    assertFalse(touch.press(new PointerSpot(eye, onSlice, DEPTH_MM, true)));
    assertEquals(MouseTouch.NOTHING_THERE, hint);
    Vec3 inside = centreMm();
    Vec3 front = new Vec3(0, 0, 5).add(inside, new Vec3());
    assertTrue(touch.press(new PointerSpot(inside, seen(inside, front), DEPTH_MM, true)));
    assertEquals("", hint);
  }

  @Test
  void aViewerInsideASolidTouchesNothing() {
    ball(bits, new Vec3(MIDDLE, MIDDLE, MIDDLE), 15);
    start(SolverKind.SMOOTH);
    Vec3 eye = centreMm();
    Vec3 spot = new Vec3(0, 0, 4).add(eye, new Vec3());
    assertFalse(touch.press(new PointerSpot(eye, spot, DEPTH_MM, true)));
  }

  @Test
  void anEdgeThatTheDrawnSurfaceOnlyGrazesIsTouchedAllTheSame() {
    hollowBall();
    start(SolverKind.SMOOTH);
    Vec3 eye = new Vec3(0, 0, 200).add(centreMm(), new Vec3());
    Vec3 drawn = world(MIDDLE + 20.7, MIDDLE, MIDDLE);
    assertTrue(touch.press(new PointerSpot(eye, drawn, DEPTH_MM, true)));
    runFrames(30);
  }

  @Test
  void aKeyFreesThePoint() {
    hollowBall();
    start(SolverKind.SMOOTH);
    Vec3 eye = new Vec3(100, 40, 10).add(centreMm(), new Vec3());
    touch.press(new PointerSpot(eye, seen(eye, centreMm()), DEPTH_MM, true));
    runFrames(300);
    assertTrue(frame.forceLengthNewton() > 0.5);
    touch.free();
    runFrames(2);
    assertEquals(0, frame.forceLengthNewton());
    assertFalse(frame.point().contact);
    assertTrue(pointMm().sub(seen(eye, centreMm()), new Vec3()).length() > 1);
    assertEquals(2, frame.statistics().freed());
  }

  @Test
  void aRecordedSessionOfTheMouseReplaysToTheSameBits(@TempDir Path folder) throws Exception {
    hollowBall();
    Path file = folder.resolve("t.csv");
    SampleRecorder recorder = new SampleRecorder();
    start(SolverKind.SMOOTH, device -> new RecordingDevice(device, recorder));
    List<Vec3> points = new ArrayList<>();
    for (int n = 0; n < 3; n++) {
      Vec3 eye = new Vec3(n == 1 ? -100 : 100, 20, 10 * n).add(centreMm(), new Vec3());
      touch.press(new PointerSpot(eye, seen(eye, centreMm()), DEPTH_MM, true));
      for (int m = 0; m < 200; m++) {
        runFrames(1);
        points.add(new Vec3().set(frame.point().position));
      }
    }
    try (Writer writer = Files.newBufferedWriter(file)) {
      recorder.drainTo(new TrajectoryWriter(writer, Double::toString));
    }
    List<Vec3> replayed = new ArrayList<>();
    ReplayRun.Result result =
        ReplayRun.inWorld(scene, TrajectoryFile.read(file, true))
            .run((n, d, p, f, state, freed) -> replayed.add(new Vec3().set(state.position)));
    assertEquals(3, result.statistics().freed());
    assertEquals(points.size() + 1, replayed.size());
    for (int n = 0; n < points.size(); n++) {
      assertTrue(points.get(n).sameBits(replayed.get(n + 1)), "frame " + n);
    }
  }

  private void hollowBall() {
    Vec3 middle = new Vec3(MIDDLE, MIDDLE, MIDDLE);
    ball(bits, middle, 20);
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          if (distance(i, j, k, middle) < 14) {
            bits.clear(i, j, k);
          }
        }
      }
    }
  }

  private static void ball(BitCube dest, Vec3 middle, double radius) {
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          if (distance(i, j, k, middle) < radius) {
            dest.set(i, j, k);
          }
        }
      }
    }
  }

  private static double distance(int i, int j, int k, Vec3 middle) {
    return new Vec3(i + 0.5, j + 0.5, k + 0.5).sub(middle, new Vec3()).length();
  }

  private void start(SolverKind solver) {
    start(solver, device -> device);
  }

  private void start(SolverKind solver, UnaryOperator<HapticDevice> around) {
    SegmentedVolume volume =
        new SegmentedVolume(GRID, List.of(new Segment("ball", bits, 0xffffff)));
    scene = new ContactScene(volume, ContactSettings.standard(solver));
    mouse = new MouseDevice(scene.handTarget(), ManualClock.MS);
    touch = new MouseTouch(new DrawnSolids(volume, List.of()), mouse, text -> hint = text);
    FrameSettings settings = scene.liveFrame(mouse.specification(), 0.5);
    GridDevice device = GridDevice.fromWorld(around.apply(mouse), GRID);
    frame = scene.newFrame(device, settings, FramePublisher.NONE);
    runFrame();
    judge = new LegJudge(bits, frame.point().position);
  }

  private void runFrames(int count) {
    for (int n = 0; n < count; n++) {
      runFrame();
      if (frame.wasFreed()) {
        beginChain();
      }
      assertNull(judge.faultOf(frame.point()), () -> "seed " + Seeds.seed());
    }
  }

  private void runFrame() {
    nowNanos += ManualClock.MS;
    frame.run(nowNanos);
    lastDevice = new Vec3().set(frame.sample().positionMm);
  }

  /** Begins a new chain of legs where the frame set the point free, which no solid may touch. */
  private void beginChain() {
    LegPath legs = frame.point().legs;
    Vec3 start = new Vec3().set(frame.point().position);
    if (legs.count() > 0) {
      start.set(legs.start(0, 0), legs.start(0, 1), legs.start(0, 2));
    }
    Ray place = new Ray().from(start.x, start.y, start.z).to(start.x, start.y, start.z);
    assertFalse(ExactOracle.touchesAny(bits, place), "the point is set free in a free place");
    judge = new LegJudge(bits, start);
  }

  private static Vec3 eye(Random random) {
    Vec3 direction = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    return direction.mul(120 / direction.length(), direction).add(centreMm(), direction);
  }

  /** Returns the first point of a solid on the way from the eye, found in steps of 1/64 voxel. */
  private Vec3 seen(Vec3 eyeMm, Vec3 aimMm) {
    Vec3 sight = aimMm.sub(eyeMm, new Vec3());
    double step = 0.5 / 64 / sight.length();
    Vec3 at = new Vec3();
    for (double t = 0; t < 3; t += step) {
      sight.mul(t, at).add(eyeMm, at);
      Vec3 grid = GRID.worldToGrid(at, new Vec3());
      int i = (int) Math.floor(grid.x);
      int j = (int) Math.floor(grid.y);
      int k = (int) Math.floor(grid.z);
      if (GRID.contains(i, j, k) && bits.get(i, j, k)) {
        return at;
      }
    }
    throw new AssertionError("nothing is seen from " + eyeMm + " at " + aimMm);
  }

  private static Vec3 towards(Vec3 from, Vec3 to, double distanceMm) {
    Vec3 way = to.sub(from, new Vec3());
    return way.mul(distanceMm / way.length(), way).add(from, way);
  }

  private static Vec3 world(double i, double j, double k) {
    return GRID.gridToWorld(new Vec3(i, j, k), new Vec3());
  }

  private static Vec3 centreMm() {
    return world(MIDDLE, MIDDLE, MIDDLE);
  }

  private Vec3 pointMm() {
    return GRID.gridToWorld(frame.point().position, new Vec3());
  }

  private Vec3 forceWorld() {
    return GRID.gridMmToWorld().rotate(frame.forceNewton(), new Vec3());
  }
}
