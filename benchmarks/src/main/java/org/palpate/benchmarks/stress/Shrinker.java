package org.palpate.benchmarks.stress;

import java.util.ArrayList;
import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.BitCube;

/**
 * Shrinks a failing case while it fails: it removes frames, then solid voxels, in ever smaller
 * pieces. Source: Zeller and Hildebrandt 2002, delta debugging, complements only.
 */
final class Shrinker {
  private static final int PASSES = 3;

  private final SolverFactory factory;

  /** Creates a shrinker for the cases of a solver. */
  Shrinker(SolverFactory factory) {
    this.factory = factory;
  }

  /** Returns the smallest case found. */
  FailedCase shrink(FailedCase failed) {
    FailedCase least = failed;
    for (int pass = 0; pass < PASSES; pass++) {
      least = withFewerFrames(least);
      least = withFewerVoxels(least);
    }
    return least;
  }

  private FailedCase withFewerFrames(FailedCase failed) {
    List<Vec3> remaining = upToFault(failed.scene(), failed.start(), failed.devices());
    for (int piece = remaining.size() / 2; piece >= 1; piece /= 2) {
      for (int at = 0; at + piece <= remaining.size(); ) {
        List<Vec3> fewer = without(remaining, at, piece);
        List<Vec3> failing = upToFault(failed.scene(), failed.start(), fewer);
        if (failing == null) {
          at += piece;
        } else {
          remaining = failing;
        }
      }
    }
    return new FailedCase(failed.scene(), failed.start(), remaining, failed.caseSeed());
  }

  private FailedCase withFewerVoxels(FailedCase failed) {
    HostileScene scene = failed.scene();
    List<Vec3> solids = solids(scene.bits());
    for (int piece = Math.max(1, solids.size() / 2); piece >= 1; piece /= 2) {
      for (int at = 0; at + piece <= solids.size(); ) {
        List<Vec3> fewer = without(solids, at, piece);
        HostileScene smaller = sceneOf(scene, fewer);
        if (upToFault(smaller, failed.start(), failed.devices()) == null) {
          at += piece;
        } else {
          solids = fewer;
        }
      }
    }
    return new FailedCase(
        sceneOf(scene, solids), failed.start(), failed.devices(), failed.caseSeed());
  }

  private static <T> List<T> without(List<T> all, int at, int count) {
    List<T> rest = new ArrayList<>(all.subList(0, at));
    rest.addAll(all.subList(at + count, all.size()));
    return rest;
  }

  private static List<Vec3> solids(BitCube bits) {
    List<Vec3> solids = new ArrayList<>();
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.get(i, j, k)) {
            solids.add(new Vec3(i, j, k));
          }
        }
      }
    }
    return solids;
  }

  private static HostileScene sceneOf(HostileScene like, List<Vec3> solids) {
    BitCube bits = new BitCube(like.bits().sizeX(), like.bits().sizeY(), like.bits().sizeZ());
    solids.forEach(voxel -> bits.set((int) voxel.x, (int) voxel.y, (int) voxel.z));
    return new HostileScene(like.kind(), bits, like.spacingMm(), like.maxStepMm());
  }

  /** Returns the devices up to the first frame with a fault; null if there is none. */
  private List<Vec3> upToFault(HostileScene scene, Vec3 start, List<Vec3> devices) {
    CollisionScene collisionScene = new CollisionScene(List.of(scene.bits()));
    FrameJudge judge = new FrameJudge(scene, start, factory);
    ProxySolver solver = factory.make(scene.metric(), scene.maxStepMm());
    InteractionPoint point = new InteractionPoint();
    point.position.set(start);
    for (int frame = 0; frame < devices.size(); frame++) {
      solver.follow(collisionScene, devices.get(frame), point);
      if (judge.fault(devices.get(frame), point, factory.steps(solver)) != null) {
        return new ArrayList<>(devices.subList(0, frame + 1));
      }
    }
    return null;
  }
}
