package org.palpate.device;

import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;

/**
 * The motion of the simulated hand: gestures made of strokes, a stroke being a way from the last
 * place to another in a number of samples. Same bits on every JDK: {@code SplittableRandom} by its
 * specified {@code nextLong} and plain arithmetic.
 */
final class SimulatedHand {
  private static final int MOST_STROKES = 16;
  private static final double NANOS_PER_MS = 1e6;

  /** Speeds of tearing away and tunnelling, voxels a sample. */
  private static final double SLOWEST_TEAR = 5;

  private static final double FASTEST_TEAR = 50;

  /** How far above the surface the hand hovers, voxels. */
  private static final double HOVER_VOXELS = 6;

  private static final double LEAST_DEPTH_VOXELS = 0.5;
  private static final double MOST_DEPTH_VOXELS = 6;

  private final SplittableRandom random;
  private final HandTarget target;
  private final Vec3 centreMm;
  private final double radiusMm;
  private final double samplesPerMs;

  private final Vec3[] ends = new Vec3[MOST_STROKES];
  private final int[] samples = new int[MOST_STROKES];
  private int strokes;
  private int stroke;
  private int sample;

  private final Vec3 start = new Vec3();
  private final Vec3 anchor = new Vec3();
  private final Vec3 outward = new Vec3();
  private final Vec3 place = new Vec3();

  SimulatedHand(long seed, HandTarget target, long intervalNanos) {
    random = new SplittableRandom(seed);
    this.target = target;
    centreMm = target.centreMm();
    radiusMm = target.radiusMm();
    samplesPerMs = NANOS_PER_MS / intervalNanos;
    for (int i = 0; i < MOST_STROKES; i++) {
      ends[i] = new Vec3();
    }
    chooseDirection();
    start.set(outward).mul(1.2 * radiusMm, start).add(centreMm, start);
    press();
  }

  /** Writes the next position, world mm, into {@code dest}. */
  void next(Vec3 dest) {
    if (stroke == strokes) {
      strokes = 0;
      stroke = 0;
      chooseGesture();
    }
    sample++;
    double t = (double) sample / samples[stroke];
    double eased = t * t * t * (10 + t * (6 * t - 15));
    ends[stroke].sub(start, dest).mul(eased, dest).add(start, dest);
    if (sample == samples[stroke]) {
      start.set(ends[stroke++]);
      sample = 0;
    }
  }

  private void chooseGesture() {
    int choice = (int) ((random.nextLong() >>> 1) % 100);
    if (choice < 30) {
      press();
    } else if (choice < 65) {
      slide();
    } else if (choice < 80) {
      tap();
    } else if (choice < 90) {
      jerkAway();
    } else {
      tunnel();
    }
  }

  private void press() {
    chooseAnchor();
    strokeTo(HOVER_VOXELS, between(250, 500));
    strokeTo(-between(LEAST_DEPTH_VOXELS, MOST_DEPTH_VOXELS), between(80, 300));
    hold(between(100, 400));
    strokeTo(HOVER_VOXELS, between(80, 300));
  }

  private void slide() {
    chooseAnchor();
    double depth = -between(LEAST_DEPTH_VOXELS, MOST_DEPTH_VOXELS);
    strokeTo(HOVER_VOXELS, between(200, 400));
    strokeTo(depth, between(80, 200));
    int ways = 1 + (int) ((random.nextLong() >>> 1) % 4);
    for (int i = 0; i < ways; i++) {
      chooseNeighbour();
      strokeTo(depth, between(150, 600));
    }
    strokeTo(HOVER_VOXELS, between(80, 200));
  }

  private void tap() {
    chooseAnchor();
    strokeTo(HOVER_VOXELS, between(200, 400));
    int taps = 2 + (int) ((random.nextLong() >>> 1) % 4);
    for (int i = 0; i < taps; i++) {
      strokeTo(-between(LEAST_DEPTH_VOXELS, MOST_DEPTH_VOXELS), between(15, 60));
      strokeTo(HOVER_VOXELS / 2, between(15, 60));
    }
  }

  private void jerkAway() {
    chooseAnchor();
    strokeTo(HOVER_VOXELS, between(200, 400));
    strokeTo(-MOST_DEPTH_VOXELS, between(80, 200));
    hold(between(20, 60));
    place.set(outward).mul(radiusMm, place).add(anchor, place);
    tearTo(place);
    hold(between(20, 60));
  }

  private void tunnel() {
    chooseAnchor();
    place.set(outward).mul(radiusMm, place).add(anchor, place);
    addStroke(place, samplesFor(between(100, 200)));
    place.set(outward).mul(-2 * radiusMm, place).add(anchor, place);
    tearTo(place);
    hold(between(20, 60));
  }

  private void chooseAnchor() {
    int points = target.surfaceMm().size();
    if (points > 0) {
      anchor.set(target.surfaceMm().get((int) ((random.nextLong() >>> 1) % points)));
      anchor.sub(centreMm, outward);
      normalizeOutward();
    } else {
      chooseDirection();
      outward.mul(between(0.2, 0.6) * radiusMm, anchor).add(centreMm, anchor);
    }
  }

  /** Moves the anchor to the nearest of a few others, as a sliding hand does. */
  private void chooseNeighbour() {
    double fromX = anchor.x;
    double fromY = anchor.y;
    double fromZ = anchor.z;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 8; i++) {
      chooseAnchor();
      double x = anchor.x - fromX;
      double y = anchor.y - fromY;
      double z = anchor.z - fromZ;
      double square = x * x + y * y + z * z;
      if (square < least && square > 0) {
        least = square;
        place.set(anchor);
      }
    }
    anchor.set(least < Double.POSITIVE_INFINITY ? place : anchor);
    anchor.sub(centreMm, outward);
    normalizeOutward();
  }

  private void chooseDirection() {
    outward.set(between(-1, 1), between(-1, 1), between(-1, 1));
    normalizeOutward();
  }

  private void normalizeOutward() {
    double length = outward.length();
    if (length > 0) {
      outward.mul(1 / length, outward);
    } else {
      outward.set(0, 0, 1);
    }
  }

  private void strokeTo(double aboveVoxels, double ms) {
    place.set(outward).mul(aboveVoxels * target.voxelMm(), place).add(anchor, place);
    addStroke(place, samplesFor(ms));
  }

  private void hold(double ms) {
    addStroke(strokes == 0 ? start : ends[strokes - 1], samplesFor(ms));
  }

  /** A stroke whose mean speed lies between the slowest and the fastest tear. */
  private void tearTo(Vec3 end) {
    Vec3 from = strokes == 0 ? start : ends[strokes - 1];
    double x = end.x - from.x;
    double y = end.y - from.y;
    double z = end.z - from.z;
    double voxels = Math.sqrt(x * x + y * y + z * z) / target.voxelMm();
    addStroke(end, (int) (voxels / between(SLOWEST_TEAR, FASTEST_TEAR)));
  }

  private void addStroke(Vec3 end, int inSamples) {
    ends[strokes].set(end);
    samples[strokes++] = Math.max(1, inSamples);
  }

  private int samplesFor(double ms) {
    return (int) (ms * samplesPerMs);
  }

  private double between(double low, double high) {
    return low + (high - low) * ((random.nextLong() >>> 11) * 0x1p-53);
  }
}
