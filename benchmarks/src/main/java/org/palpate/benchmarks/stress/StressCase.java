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
 * One scene and one hand, the same to the bit whenever it is made from the same seed: so a run of
 * any length needs no memory of its own, and any case can be had again.
 */
final class StressCase {
  /** Frames in which the hand moves. */
  static final int FRAMES = 1000;

  /** With those after them, in which it rests, so that the point has to. */
  static final int ALL_FRAMES = 1200;

  final HostileScene scene;
  final Vec3 start = new Vec3();
  private final HostileHand hand;

  StressCase(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    scene = HostileScene.next(random);
    hand = new HostileHand(random, scene.bits());
    hand.next(new Vec3(0.5, 0.5, 0.5), start);
    place(start);
  }

  /** Moves a start that touches a solid to the nearest free place, as a replay does. */
  private void place(Vec3 at) {
    CollisionScene obstacles = obstacles();
    NearestFreeVoxel free = new NearestFreeVoxel(scene.metric());
    if (obstacles.touches(at.x, at.y, at.z)) {
      free.find(obstacles, at, at);
    }
  }

  CollisionScene obstacles() {
    return new CollisionScene(List.of(scene.bits()));
  }

  /** Writes where the device is in a frame; {@code p} is where the interaction point is. */
  void next(int frame, Vec3 p, Vec3 device) {
    if (frame < FRAMES) {
      hand.next(p, device);
    }
  }

  /** The device's way when this solver follows it, the start first, {@code frames} in all. */
  List<Vec3> devices(ProxySolver solver, int frames) {
    List<Vec3> way = new ArrayList<>();
    InteractionPoint point = new InteractionPoint();
    point.position.set(start);
    Vec3 device = new Vec3().set(start);
    CollisionScene obstacles = obstacles();
    for (int frame = 0; frame < frames; frame++) {
      next(frame, point.position, device);
      way.add(new Vec3().set(device));
      solver.follow(obstacles, device, point);
    }
    return way;
  }
}
