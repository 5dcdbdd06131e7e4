package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;

/**
 * Slides from bits and from grey values over slices of 2, 3 and 5 mm. With 5 mm and grey values the
 * isosurface is far from the solid; shapes then differ between the isosurface and the level nearer
 * to the solid. Legs are free, the force never jumps, the point comes to rest, and a frame reads a
 * bounded number of windows.
 */
class ThickSliceForceTest {
  private static final int PIXELS = 64;
  private static final double HEIGHT_MM = 70;
  private static final double TOP_MM = 42;
  private static final double FULL = 1000;
  private static final int SAMPLES_ALONG_Z = 10;
  private static final double STIFFNESS = 0.5;
  private static final int DOWN_FRAMES = 100;
  private static final double SLIDE_MM = 34;
  private static final int FRAMES_TO_REST = 20;

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final Vec3 force = new Vec3();
  private double sliceMm;
  private ContactForce contact;
  private SmoothSolver solver;
  private JudgedSolver judged;
  private CollisionScene scene;

  /** A solid, in mm. */
  private interface Solid {
    boolean at(double x, double y, double z);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 5, 8})
  void overSlitsCombsAndHoles(int width) {
    slideOver((x, y, z) -> z < TOP_MM && !(x >= 32 && x < 32 + width));
    slideOver((x, y, z) -> z < TOP_MM && (int) x / width % 2 == 0);
    slideOver((x, y, z) -> z < TOP_MM && !(x >= 32 && x < 32 + width && y >= 32 && y < 32 + width));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 5, 8})
  void overRidgesRodsAndSheets(int width) {
    slideOver((x, y, z) -> z < 30 || (z < TOP_MM && x >= 32 && x < 32 + width));
    slideOver((x, y, z) -> z < TOP_MM && z > TOP_MM - width && Math.abs(y - 32.3) < width / 2.0);
    slideOver((x, y, z) -> z < TOP_MM && z > TOP_MM - width);
  }

  @ParameterizedTest
  @CsvSource({"20", "60", "100", "140"})
  void overEdgesAndGrooves(double degrees) {
    double slope = StrictMath.tan(StrictMath.toRadians(degrees / 2));
    slideOver((x, y, z) -> (TOP_MM - z) * slope > Math.abs(x - 32));
    slideOver((x, y, z) -> z < TOP_MM && (z - TOP_MM + 15) * slope <= Math.abs(x - 32));
  }

  private void slideOver(Solid solid) {
    slideOver(solid, 2);
    slideOver(solid, 3);
    slideOver(solid, 5);
  }

  private void slideOver(Solid solid, double newSliceMm) {
    sliceMm = newSliceMm;
    ScalarVolume values = values(solid);
    BitCube bits = bits(values);
    scene = new CollisionScene(List.of(bits));
    for (double depth : new double[] {0.7, 4}) {
      for (double speed : new double[] {0.1, 2}) {
        slide(bits, new SmoothSolver(metric(), 8), depth, speed);
        GreyIsosurface grey = new GreyIsosurface(values, FULL / 2, FULL / 2);
        slide(bits, new SmoothSolver(metric(), 8, grey), depth, speed);
      }
    }
  }

  private GridMetric metric() {
    return new GridMetric(1, 1, sliceMm);
  }

  /** Presses in, slides there and back, and rests now and then. */
  private void slide(BitCube bits, SmoothSolver newSolver, double depth, double speed) {
    solver = newSolver;
    judged = new JudgedSolver(solver, bits);
    Vec3 mm = new Vec3(15.1, 32.3, TOP_MM + 10);
    place(mm, device);
    point.position.set(device);
    contact = new ContactForce(metric(), ForceSettings.of(STIFFNESS, 0));
    force.set(0, 0, 0);
    int there = (int) (SLIDE_MM / speed);
    for (int frame = 0; frame < DOWN_FRAMES + 2 * there; frame++) {
      Vec3 last = new Vec3().set(mm);
      if (frame < DOWN_FRAMES) {
        mm.z -= (10 + depth) / DOWN_FRAMES;
      } else {
        mm.x += frame < DOWN_FRAMES + there ? speed : -speed;
      }
      place(mm, device);
      step(mm.sub(last, last).length());
      if (frame % 37 == 0) {
        rest();
      }
    }
  }

  private void step(double motionMm) {
    Vec3 before = new Vec3().set(force);
    judged.follow(scene, device, point);
    contact.compute(point, device, force);
    double change = force.sub(before, before).length();
    assertTrue(change <= 1.5 * STIFFNESS * Math.max(0.05, motionMm) * (1 + 1e-9), "" + change);
    assertTrue(solver.windows() <= SmoothSolver.MOST_WINDOWS);
  }

  private void rest() {
    Vec3 before = new Vec3();
    int frames = 0;
    do {
      before.set(point.position);
      step(0);
      frames++;
      assertTrue(frames <= FRAMES_TO_REST, "the point comes to rest");
    } while (!before.sameBits(point.position));
  }

  private void place(Vec3 mm, Vec3 dest) {
    dest.set(mm.x, mm.y, mm.z / sliceMm);
  }

  private int slices() {
    return (int) (HEIGHT_MM / sliceMm);
  }

  /** Returns the solid fractions of voxels, sampled. */
  private ScalarVolume values(Solid solid) {
    ScalarVolume values =
        ScalarVolume.of(VoxelGrid.ofUnitVoxels(PIXELS, PIXELS, slices()), Storage.INT16);
    for (int k = 0; k < slices(); k++) {
      for (int j = 0; j < PIXELS; j++) {
        for (int i = 0; i < PIXELS; i++) {
          values.set(i, j, k, Math.rint(FULL * fraction(solid, i, j, k)));
        }
      }
    }
    return values;
  }

  private double fraction(Solid solid, int i, int j, int k) {
    int inside = 0;
    for (int n = 0; n < 4 * SAMPLES_ALONG_Z; n++) {
      double x = i + 0.25 + 0.5 * (n & 1);
      double y = j + 0.25 + 0.5 * ((n >> 1) & 1);
      double z = sliceMm * (k + ((n >> 2) + 0.5) / SAMPLES_ALONG_Z);
      inside += solid.at(x, y, z) ? 1 : 0;
    }
    return inside / (4.0 * SAMPLES_ALONG_Z);
  }

  private BitCube bits(ScalarVolume values) {
    BitCube bits = new BitCube(PIXELS, PIXELS, slices());
    for (int k = 0; k < slices(); k++) {
      for (int j = 0; j < PIXELS; j++) {
        for (int i = 0; i < PIXELS; i++) {
          if (values.value(i, j, k) >= FULL / 2) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }
}
