package org.palpate.benchmarks.elastic;

import java.util.List;
import java.util.SplittableRandom;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.edit.BrushEdit;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.LegPath;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * Attacks elastic segments: a hand of up to 1.6 m/s that jumps, drills and fills; a device that
 * tears away; updates that stop and come back. Every leg is judged exactly in material coordinates,
 * and every tetrahedron of fields as the haptic thread uses them.
 */
final class ElasticAttack {
  private static final double TORN_AWAY_VOXELS = 1e9;

  private static final double[][] SPACINGS = {
    {1, 1, 1}, {1, 1, 2}, {0.4, 0.9, 0.7}, {1, 1, 5}, {3, 1, 1}
  };

  private final SplittableRandom random;
  private final boolean windowed;
  private final ElasticLegJudge legJudge = new ElasticLegJudge();
  private final TetrahedronJudge fieldJudge = new TetrahedronJudge();
  private final Vec3 start = new Vec3();
  private final Vec3 goal = new Vec3();
  private double speed;
  private int stalled;
  private long frames;
  private long freed;
  private long updates;
  private long scaledBack;
  private long refused;
  private long clipped;
  private long windowless;

  /** Prepares an attack without windows. */
  ElasticAttack(long seed) {
    this(seed, false);
  }

  /**
   * Prepares an attack.
   *
   * @param windowed whether contacts are so sharp that each has a window
   */
  ElasticAttack(long seed, boolean windowed) {
    random = new SplittableRandom(seed);
    this.windowed = windowed;
  }

  /** Attacks until so many legs and tetrahedra are judged in all. */
  void attack(UpdatePace pace, long leastLegs, long leastTetrahedra) {
    while (legJudge.legs() < leastLegs || fieldJudge.judged() < leastTetrahedra) {
      attack(pace);
    }
  }

  /** Returns the figures of all attacks so far. */
  List<RigidFigure> figures() {
    return List.of(
        noneOf("legs that touch a solid", legJudge.touching()),
        noneOf("broken chains", legJudge.broken()),
        noneOf("tetrahedra that are not positive", fieldJudge.notPositive()),
        noneOf("verdicts in doubles that decimal fractions do not give", legJudge.differing()),
        noneOf("planted legs that were not found", legJudge.plantedUnfound()),
        countOf("legs judged", legJudge.legs()),
        countOf("verdicts also given in decimal fractions alone", legJudge.compared()),
        countOf("planted legs", legJudge.plantedLegs()),
        countOf("tetrahedra judged", fieldJudge.judged()),
        countOf("tetrahedra decided in decimal fractions", fieldJudge.exactDecisions()),
        countOf("frames", frames),
        countOf("updates", updates),
        countOf("updates scaled back", scaledBack),
        countOf("updates refused", refused),
        countOf("updates without their window", windowless),
        countOf("judged fields with a window", fieldJudge.windows()),
        countOf("frames with a clipped force", clipped),
        countOf("points set free", freed));
  }

  private RigidFigure noneOf(String name, long count) {
    return new RigidFigure("attack", condition(), name, (double) count, "", 0);
  }

  private RigidFigure countOf(String name, long count) {
    return RigidFigure.of("attack", condition(), name, (double) count, "");
  }

  private String condition() {
    return windowed ? "hostile frames, contacts in a window" : "hostile frames";
  }

  private void attack(UpdatePace pace) {
    SoftScene scene = scene();
    double edge = scene.metric().shortestEdgeMm();
    double cell = (5 + random.nextInt(5)) * Math.max(edge, scene.metric().spacingZ() / 2);
    Softness softness =
        new Softness(
            Math.pow(10, 3 + 2.5 * random.nextDouble()),
            Math.pow(2, -2 + 4 * random.nextDouble()),
            cell,
            windowed ? sharpRadiusMm(scene.metric(), cell) : 2 * cell,
            1e-3,
            random.nextBoolean());
    ElasticSession session = new ElasticSession(scene, softness, windowed);
    boolean edits = random.nextInt(3) > 0;
    session.hand().set(scene.soft().sizeX() / 2.0 + 0.3, scene.soft().sizeY() / 2.0 + 0.4, -2);
    session.run();
    legJudge.begin(session.point().position);
    goal.set(session.hand());
    stalled = 0;
    for (int n = 0; n < pace.framesPerRound; n++) {
      move(session, scene);
      if (edits && random.nextInt(100) == 0) {
        edit(session, scene);
      }
      updateUnlessStalled(session, pace);
      session.runFrame();
      judge(session, scene);
      if (n % pace.framesPerJudgement == pace.framesPerJudgement / 2) {
        fieldJudge.judge(session.body());
      }
    }
    frames += pace.framesPerRound;
    updates += session.body().counters().updates();
    scaledBack += session.body().counters().scaledBack();
    refused += session.body().counters().refused();
    clipped += session.body().contact().clippedFrames();
    windowless += session.body().counters().windowless();
  }

  /**
   * Returns a radius for which a window has cells of half or a quarter of the edge. Cells are whole
   * voxels long, so it is at least two voxels, and a quarter needs up to a voxel more.
   */
  private double sharpRadiusMm(GridMetric metric, double cellMm) {
    double voxelMm = Math.max(metric.spacingX(), Math.max(metric.spacingY(), metric.spacingZ()));
    double wanted = random.nextBoolean() ? cellMm : cellMm / 2 + voxelMm;
    return Math.max(2 * voxelMm, wanted);
  }

  private SoftScene scene() {
    double[] mm = SPACINGS[random.nextInt(SPACINGS.length)];
    GridMetric metric = new GridMetric(mm[0], mm[1], mm[2]);
    int kind = random.nextInt(4);
    if (kind == 0) {
      return SoftScene.block(32, 20, metric);
    }
    String name = new String[] {"sphere:40", "shell:40", "maze:32"}[kind - 1];
    BitCube bits = Phantom.parse(name).segments().segments().get(0).bits();
    BitCube still = new BitCube(bits.sizeX(), bits.sizeY(), bits.sizeZ());
    return new SoftScene(name, bits, still, metric);
  }

  /** Moves the hand towards a goal that changes; sometimes it jumps, or the device tears away. */
  private void move(ElasticSession session, SoftScene scene) {
    Vec3 hand = session.hand();
    if (random.nextInt(150) == 0) {
      BitCube bits = scene.soft();
      goal.set(
          bits.sizeX() * (1.2 * random.nextDouble() - 0.1),
          bits.sizeY() * (1.2 * random.nextDouble() - 0.1),
          bits.sizeZ() * (1.2 * random.nextDouble() - 0.1));
      speed = Math.pow(10, -2 + 2.2 * random.nextDouble());
    }
    if (random.nextInt(1_500) == 0) {
      hand.set(goal);
    }
    if (random.nextInt(3_000) == 0) {
      hand.set(TORN_AWAY_VOXELS * random.nextDouble(-1, 1), hand.y, TORN_AWAY_VOXELS);
      return;
    }
    Vec3 way = goal.sub(hand, new Vec3());
    double length = way.length();
    way.mul(length <= speed || length > TORN_AWAY_VOXELS / 1e6 ? 1 : speed / length, way);
    hand.add(way, hand);
  }

  private void edit(ElasticSession session, SoftScene scene) {
    boolean drill = random.nextInt(3) > 0;
    BitCube bits = scene.soft();
    Vec3 centre =
        drill
            ? session.point().position
            : new Vec3(
                bits.sizeX() * random.nextDouble(),
                bits.sizeY() * random.nextDouble(),
                bits.sizeZ() * random.nextDouble());
    session.edits().offer(new BrushEdit(random.nextInt(2), centre, 3, !drill));
  }

  /** Leaves updates out from time to time, as if their thread stalled. */
  private void updateUnlessStalled(ElasticSession session, UpdatePace pace) {
    if (stalled == 0 && random.nextInt(pace.framesPerStop) == 0) {
      stalled = random.nextInt(pace.longestStopFrames);
    }
    if (stalled > 0) {
      stalled--;
    } else {
      session.update();
    }
  }

  private void judge(ElasticSession session, SoftScene scene) {
    LegPath path = session.point().legs;
    if (session.wasFreed()) {
      freed++;
      boolean stands = path.count() == 0;
      legJudge.begin(
          stands
              ? session.point().position
              : start.set(path.start(0, 0), path.start(0, 1), path.start(0, 2)));
    }
    legJudge.judge(path, session.point().position, scene.solids());
  }
}
