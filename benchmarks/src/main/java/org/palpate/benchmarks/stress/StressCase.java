package org.palpate.benchmarks.stress;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/**
 * One scene and one hand. The same seed gives the same bits, so that a run of any length needs no
 * memory and every case can be repeated.
 */
final class StressCase {
  /** The number of frames in which the hand moves. */
  static final int FRAMES = 1000;

  /** The number of all frames; in the last ones the hand rests, so that the point must rest too. */
  static final int ALL_FRAMES = 1200;

  final HostileScene scene;
  final Vec3 start = new Vec3();
  private final HostileHand hand;

  /** Makes the case of a seed. */
  StressCase(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    scene = HostileScene.next(random);
    hand = new HostileHand(random, scene.bits());
    hand.next(new Vec3(0.5, 0.5, 0.5), start);
    moveToFreeVoxel(start);
  }

  /** Moves a start that touches a solid to the nearest free voxel, as a replay does. */
  private void moveToFreeVoxel(Vec3 at) {
    CollisionScene collisionScene = collisionScene();
    NearestFreeVoxel free = new NearestFreeVoxel(scene.metric());
    if (collisionScene.touches(at.x, at.y, at.z)) {
      free.find(collisionScene, at, at);
    }
  }

  /** Returns a new collision scene of the solids. */
  CollisionScene collisionScene() {
    return new CollisionScene(List.of(scene.bits()));
  }

  /** Writes the device position of a frame; {@code p} is the interaction point. */
  void next(int frame, Vec3 p, Vec3 device) {
    if (frame < FRAMES) {
      hand.next(p, device);
    }
  }

  /** Returns the positions of the device that this solver follows, for a number of frames. */
  List<Vec3> devices(ProxySolver solver, int frames) {
    List<Vec3> positions = new ArrayList<>();
    InteractionPoint point = new InteractionPoint();
    point.position.set(start);
    Vec3 device = new Vec3().set(start);
    CollisionScene collisionScene = collisionScene();
    for (int frame = 0; frame < frames; frame++) {
      next(frame, point.position, device);
      positions.add(new Vec3().set(device));
      solver.follow(collisionScene, device, point);
    }
    return positions;
  }
}
