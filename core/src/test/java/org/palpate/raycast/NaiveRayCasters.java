package org.palpate.raycast;

import java.util.NavigableSet;
import java.util.TreeSet;
import org.palpate.volume.BitCube;

/** The sampling casters without a shortcut: every sample, in order. */
final class NaiveRayCasters {
  private NaiveRayCasters() {}

  static boolean sampled(double step, BitCube bits, Ray ray, RayHit hit) {
    double dx = ray.toX - ray.fromX;
    double dy = ray.toY - ray.fromY;
    double dz = ray.toZ - ray.fromZ;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    for (int n = 0; n * step < length; n++) {
      if (hits(bits, ray, n * step / length, hit)) {
        return true;
      }
    }
    return endHits(bits, ray, hit);
  }

  static boolean gridPlanes(BitCube bits, Ray ray, RayHit hit) {
    NavigableSet<Double> crossings = new TreeSet<>();
    crossings.add(0.0);
    crossings.add(1.0);
    addPlanes(ray.fromX, ray.toX, crossings);
    addPlanes(ray.fromY, ray.toY, crossings);
    addPlanes(ray.fromZ, ray.toZ, crossings);
    double last = 0;
    for (double next : crossings.tailSet(0.0, false)) {
      if (hits(bits, ray, (last + next) / 2, hit)) {
        return true;
      }
      last = next;
    }
    return endHits(bits, ray, hit);
  }

  private static void addPlanes(double from, double to, NavigableSet<Double> crossings) {
    for (double plane = Math.floor(Math.min(from, to)); plane <= Math.max(from, to); plane++) {
      double t = (plane - from) / (to - from);
      if (t > 0 && t < 1) {
        crossings.add(t);
      }
    }
  }

  private static boolean endHits(BitCube bits, Ray ray, RayHit hit) {
    hit.set(1, floor(ray.toX), floor(ray.toY), floor(ray.toZ), RayHit.NO_AXIS);
    return bits.get(hit.i, hit.j, hit.k);
  }

  private static boolean hits(BitCube bits, Ray ray, double t, RayHit hit) {
    int i = floor(ray.fromX + t * (ray.toX - ray.fromX));
    int j = floor(ray.fromY + t * (ray.toY - ray.fromY));
    int k = floor(ray.fromZ + t * (ray.toZ - ray.fromZ));
    hit.set(t, i, j, k, RayHit.NO_AXIS);
    return bits.get(i, j, k);
  }

  private static int floor(double value) {
    return (int) Math.floor(value);
  }
}
