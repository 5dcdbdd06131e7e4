package org.palpate.device;

import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;

/**
 * Generates the motion of a simulated hand from gestures. A gesture consists of strokes, and a
 * stroke is a straight motion to a point in a number of samples.
 *
 * <p>The motion has the same bits on every JDK, because it uses only {@code
 * SplittableRandom.nextLong}, whose algorithm is specified, and plain arithmetic. One thread.
 */
final class SimulatedHand {
  private static final int MAX_STROKES = 16;
  private static final double NANOS_PER_MS = 1e6;

  /** Least mean speed of tearing away and tunnelling, voxels a millisecond. */
  private static final double MIN_TEAR_SPEED = 5;

  /** Largest mean speed of tearing away and tunnelling, voxels a millisecond. */
  private static final double MAX_TEAR_SPEED = 50;

  /** Height at which the hand hovers above the surface. */
  private static final double HOVER_VOXELS = 6;

  private static final double MIN_DEPTH_VOXELS = 0.5;
  private static final double MAX_DEPTH_VOXELS = 6;

  /** Number of points from which a sliding hand chooses the nearest. */
  private static final int NEIGHBOUR_CHOICES = 8;

  private final SplittableRandom random;
  private final HandTarget target;
  private final Vec3 centreMm;
  private final double radiusMm;
  private final double samplesPerMs;

  private final Vec3[] ends = new Vec3[MAX_STROKES];
  private final int[] samples = new int[MAX_STROKES];
  private int strokes;
  private int stroke;
  private int sample;

  private final Vec3 start = new Vec3();
  private final Vec3 anchor = new Vec3();
  private final Vec3 outward = new Vec3();
  private final Vec3 goal = new Vec3();

  SimulatedHand(long seed, HandTarget target, long intervalNanos) {
    random = new SplittableRandom(seed);
    this.target = target;
    centreMm = target.centreMm();
    radiusMm = target.radiusMm();
    samplesPerMs = NANOS_PER_MS / intervalNanos;
    for (int i = 0; i < MAX_STROKES; i++) {
      ends[i] = new Vec3();
    }
    chooseDirection();
    start.set(outward).mul(1.2 * radiusMm, start).add(centreMm, start);
    press();
  }

  /** Writes the next position into {@code dest}, world mm. */
  void next(Vec3 dest) {
    if (stroke == strokes) {
      strokes = 0;
      stroke = 0;
      chooseGesture();
    }
    sample++;
    double progress = smoothStep((double) sample / samples[stroke]);
    ends[stroke].sub(start, dest).mul(progress, dest).add(start, dest);
    if (sample == samples[stroke]) {
      start.set(ends[stroke++]);
      sample = 0;
    }
  }

  /** Returns 6t^5 - 15t^4 + 10t^3, which starts and ends without speed and acceleration. */
  private static double smoothStep(double t) {
    return t * t * t * (10 + t * (6 * t - 15));
  }

  private void chooseGesture() {
    int choice = below(100);
    if (choice < 30) {
      press();
    } else if (choice < 65) {
      slide();
    } else if (choice < 80) {
      tap();
    } else if (choice < 90) {
      tearAway();
    } else {
      tunnel();
    }
  }

  private void press() {
    chooseAnchor();
    strokeTo(HOVER_VOXELS, between(250, 500));
    strokeTo(-between(MIN_DEPTH_VOXELS, MAX_DEPTH_VOXELS), between(80, 300));
    hold(between(100, 400));
    strokeTo(HOVER_VOXELS, between(80, 300));
  }

  private void slide() {
    chooseAnchor();
    double depth = -between(MIN_DEPTH_VOXELS, MAX_DEPTH_VOXELS);
    strokeTo(HOVER_VOXELS, between(200, 400));
    strokeTo(depth, between(80, 200));
    int slides = 1 + below(4);
    for (int i = 0; i < slides; i++) {
      chooseNeighbour();
      strokeTo(depth, between(150, 600));
    }
    strokeTo(HOVER_VOXELS, between(80, 200));
  }

  private void tap() {
    chooseAnchor();
    strokeTo(HOVER_VOXELS, between(200, 400));
    int taps = 2 + below(4);
    for (int i = 0; i < taps; i++) {
      strokeTo(-between(MIN_DEPTH_VOXELS, MAX_DEPTH_VOXELS), between(15, 60));
      strokeTo(HOVER_VOXELS / 2, between(15, 60));
    }
  }

  private void tearAway() {
    chooseAnchor();
    strokeTo(HOVER_VOXELS, between(200, 400));
    strokeTo(-MAX_DEPTH_VOXELS, between(80, 200));
    hold(between(20, 60));
    goal.set(outward).mul(radiusMm, goal).add(anchor, goal);
    tearTo(goal);
    hold(between(20, 60));
  }

  private void tunnel() {
    chooseAnchor();
    goal.set(outward).mul(radiusMm, goal).add(anchor, goal);
    addStroke(goal, samplesFor(between(100, 200)));
    goal.set(outward).mul(-2 * radiusMm, goal).add(anchor, goal);
    tearTo(goal);
    hold(between(20, 60));
  }

  /** Chooses the point of the next gesture and the direction out of the object there. */
  private void chooseAnchor() {
    int points = target.surfaceMm().size();
    if (points > 0) {
      anchor.set(target.surfaceMm().get(below(points)));
      anchor.sub(centreMm, outward);
      normalizeOutward();
    } else {
      chooseDirection();
      outward.mul(between(0.2, 0.6) * radiusMm, anchor).add(centreMm, anchor);
    }
  }

  /** Moves the anchor to the nearest of a few other points, as a sliding hand does. */
  private void chooseNeighbour() {
    double fromX = anchor.x;
    double fromY = anchor.y;
    double fromZ = anchor.z;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < NEIGHBOUR_CHOICES; i++) {
      chooseAnchor();
      double x = anchor.x - fromX;
      double y = anchor.y - fromY;
      double z = anchor.z - fromZ;
      double square = x * x + y * y + z * z;
      if (square < least && square > 0) {
        least = square;
        goal.set(anchor);
      }
    }
    anchor.set(least < Double.POSITIVE_INFINITY ? goal : anchor);
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

  /** Adds a stroke to a point above the anchor, or below it if negative. */
  private void strokeTo(double aboveVoxels, double ms) {
    goal.set(outward).mul(aboveVoxels * target.voxelMm(), goal).add(anchor, goal);
    addStroke(goal, samplesFor(ms));
  }

  /** Adds a stroke that stays where the last one ends. */
  private void hold(double ms) {
    addStroke(strokes == 0 ? start : ends[strokes - 1], samplesFor(ms));
  }

  /** Adds a stroke at a mean speed between those of the slowest and the fastest tear. */
  private void tearTo(Vec3 end) {
    Vec3 from = strokes == 0 ? start : ends[strokes - 1];
    double x = end.x - from.x;
    double y = end.y - from.y;
    double z = end.z - from.z;
    double voxels = Math.sqrt(x * x + y * y + z * z) / target.voxelMm();
    addStroke(end, samplesFor(voxels / between(MIN_TEAR_SPEED, MAX_TEAR_SPEED)));
  }

  private void addStroke(Vec3 end, int sampleCount) {
    ends[strokes].set(end);
    samples[strokes++] = Math.max(1, sampleCount);
  }

  private int samplesFor(double ms) {
    return (int) (ms * samplesPerMs);
  }

  private int below(int bound) {
    return (int) ((random.nextLong() >>> 1) % bound);
  }

  private double between(double low, double high) {
    return low + (high - low) * ((random.nextLong() >>> 11) * 0x1p-53);
  }
}
