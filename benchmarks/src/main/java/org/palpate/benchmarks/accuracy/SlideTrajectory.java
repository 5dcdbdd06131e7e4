package org.palpate.benchmarks.accuracy;

import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;

/**
 * A device that comes down on a surface, presses to a depth, and wanders along it at a speed: the
 * same to the bit for the same numbers. Millimetres; immutable.
 */
public final class SlideTrajectory {
  private static final double START_HEIGHT_MM = 4;
  private static final double APPROACH_MM_A_FRAME = 0.05;

  /** Frames after the approach that do not count. */
  private static final int SETTLING_FRAMES = 50;

  /** How much the heading turns, a square root of a millimetre. */
  private static final double WANDER = 0.15;

  private static final double MARGIN_MM = 28;

  private final double[] devices;
  private final double[] normals;
  private final int slideStart;

  /**
   * Makes a trajectory.
   *
   * @param truth the surface, in millimetres
   * @param edgeMm the cube that it stays in, well inside
   * @param depthMm how deep the device lies in the solid once it slides
   * @param speedMmAFrame how far the nearest surface point goes in a frame
   * @param slideFrames frames that count, after the approach
   */
  public SlideTrajectory(
      AnalyticSurface truth,
      double edgeMm,
      double depthMm,
      double speedMmAFrame,
      int slideFrames,
      long seed) {
    int approach = (int) Math.ceil((depthMm + START_HEIGHT_MM) / APPROACH_MM_A_FRAME);
    slideStart = approach + SETTLING_FRAMES;
    int frames = slideStart + slideFrames;
    devices = new double[3 * frames];
    normals = new double[3 * frames];
    Wanderer wanderer = new Wanderer(truth, edgeMm, new SplittableRandom(seed));
    for (int frame = 0; frame < frames; frame++) {
      double share = Math.min(1, frame / (double) approach);
      double depth = -START_HEIGHT_MM + share * (depthMm + START_HEIGHT_MM);
      wanderer.write(depth, frame, devices, normals);
      if (frame >= approach) {
        wanderer.step(speedMmAFrame);
      }
    }
  }

  public int frames() {
    return devices.length / 3;
  }

  /** The first frame that counts. */
  public int slideStart() {
    return slideStart;
  }

  /** Writes where the device is, mm. */
  public Vec3 device(int frame, Vec3 dest) {
    return read(devices, frame, dest);
  }

  /** Writes the true unit normal at the surface point that the device stands for. */
  public Vec3 normal(int frame, Vec3 dest) {
    return read(normals, frame, dest);
  }

  private static Vec3 read(double[] from, int frame, Vec3 dest) {
    return dest.set(from[3 * frame], from[3 * frame + 1], from[3 * frame + 2]);
  }

  /** A point that walks on the surface, heading where it did but for small turns. */
  private static final class Wanderer {
    private final AnalyticSurface truth;
    private final double edgeMm;
    private final SplittableRandom random;
    private final Vec3 at = new Vec3();
    private final Vec3 normal = new Vec3();
    private final Vec3 heading = new Vec3();

    Wanderer(AnalyticSurface truth, double edgeMm, SplittableRandom random) {
      this.truth = truth;
      this.edgeMm = edgeMm;
      this.random = random;
      at.set(edgeMm / 2 + 20, edgeMm / 2 + 30, edgeMm / 2 + 50);
      heading.set(gaussian(), gaussian(), gaussian());
      for (int n = 0; n < 20; n++) {
        ontoSurface();
      }
    }

    void write(double depth, int frame, double[] toDevices, double[] toNormals) {
      toDevices[3 * frame] = at.x - depth * normal.x;
      toDevices[3 * frame + 1] = at.y - depth * normal.y;
      toDevices[3 * frame + 2] = at.z - depth * normal.z;
      toNormals[3 * frame] = normal.x;
      toNormals[3 * frame + 1] = normal.y;
      toNormals[3 * frame + 2] = normal.z;
    }

    void step(double length) {
      double turn = WANDER * Math.sqrt(length);
      for (int axis = 0; axis < 3; axis++) {
        heading.set(axis, heading.get(axis) + turn * gaussian() + awayFromWall(at.get(axis)));
      }
      double along = heading.dot(normal);
      heading.set(
          heading.x - along * normal.x, heading.y - along * normal.y, heading.z - along * normal.z);
      heading.mul(1 / heading.length(), heading);
      at.set(at.x + length * heading.x, at.y + length * heading.y, at.z + length * heading.z);
      ontoSurface();
      ontoSurface();
    }

    private double awayFromWall(double coordinate) {
      if (coordinate < MARGIN_MM) {
        return 2;
      }
      return coordinate > edgeMm - MARGIN_MM ? -2 : 0;
    }

    private void ontoSurface() {
      truth.normal(at, normal);
      double distance = truth.signedDistance(at);
      at.set(at.x - distance * normal.x, at.y - distance * normal.y, at.z - distance * normal.z);
      truth.normal(at, normal);
    }

    /** About normally distributed: the sum of twelve, alike on every machine. */
    private double gaussian() {
      double sum = -6;
      for (int n = 0; n < 12; n++) {
        sum += random.nextDouble();
      }
      return sum;
    }
  }
}
