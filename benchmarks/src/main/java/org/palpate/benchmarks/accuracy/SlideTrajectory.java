package org.palpate.benchmarks.accuracy;

import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;

/**
 * A device that comes down on a surface, presses to a depth and wanders along the surface at a
 * speed. The same arguments give the same bits. Millimetres; immutable.
 */
public final class SlideTrajectory {
  private static final double START_HEIGHT_MM = 4;
  private static final double APPROACH_MM_PER_FRAME = 0.05;

  /** Frames after the approach that are not measured. */
  private static final int SETTLING_FRAMES = 50;

  /** The strength of the heading's random turns, per square root of a millimetre. */
  private static final double WANDER = 0.15;

  private static final double MARGIN_MM = 28;

  private final double[] devices;
  private final double[] normals;
  private final int slideStart;

  /**
   * Creates a trajectory.
   *
   * @param truth the surface, in millimetres
   * @param edgeMm the edge of the cube in which the device stays
   * @param depthMm the depth of the sliding device in the solid
   * @param speedMmPerFrame the speed of the nearest surface point
   * @param slideFrames the number of measured frames, after the approach
   */
  public SlideTrajectory(
      AnalyticSurface truth,
      double edgeMm,
      double depthMm,
      double speedMmPerFrame,
      int slideFrames,
      long seed) {
    int approach = (int) Math.ceil((depthMm + START_HEIGHT_MM) / APPROACH_MM_PER_FRAME);
    slideStart = approach + SETTLING_FRAMES;
    int frames = slideStart + slideFrames;
    devices = new double[3 * frames];
    normals = new double[3 * frames];
    Wanderer wanderer = new Wanderer(truth, edgeMm, new SplittableRandom(seed));
    for (int frame = 0; frame < frames; frame++) {
      double fraction = Math.min(1, frame / (double) approach);
      double depth = -START_HEIGHT_MM + fraction * (depthMm + START_HEIGHT_MM);
      wanderer.write(depth, frame, devices, normals);
      if (frame >= approach) {
        wanderer.step(speedMmPerFrame);
      }
    }
  }

  /** Returns the number of frames, approach included. */
  public int frames() {
    return devices.length / 3;
  }

  /** Returns the first measured frame. */
  public int slideStart() {
    return slideStart;
  }

  /** Writes the device position of a frame, mm. */
  public Vec3 device(int frame, Vec3 dest) {
    return read(devices, frame, dest);
  }

  /** Writes the true unit normal at the surface point nearest to the device. */
  public Vec3 normal(int frame, Vec3 dest) {
    return read(normals, frame, dest);
  }

  private static Vec3 read(double[] from, int frame, Vec3 dest) {
    return dest.set(from[3 * frame], from[3 * frame + 1], from[3 * frame + 2]);
  }

  /** A point that moves on the surface and changes its heading by small random turns. */
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
        projectToSurface();
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
      projectToSurface();
      projectToSurface();
    }

    private double awayFromWall(double coordinate) {
      if (coordinate < MARGIN_MM) {
        return 2;
      }
      return coordinate > edgeMm - MARGIN_MM ? -2 : 0;
    }

    private void projectToSurface() {
      truth.normal(at, normal);
      double distance = truth.signedDistance(at);
      at.set(at.x - distance * normal.x, at.y - distance * normal.y, at.z - distance * normal.z);
      truth.normal(at, normal);
    }

    /** Returns an almost normally distributed number, the same on every machine. */
    private double gaussian() {
      double sum = -6;
      for (int n = 0; n < 12; n++) {
        sum += random.nextDouble();
      }
      return sum;
    }
  }
}
