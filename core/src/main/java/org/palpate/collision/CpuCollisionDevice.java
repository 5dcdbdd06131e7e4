package org.palpate.collision;

import java.util.Optional;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.PointSet;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;

/**
 * The CPU as a collision device. It judges a leg when its verdict is asked, exactly, and is the
 * reference for other devices. Keeps no copy of voxels or points.
 */
final class CpuCollisionDevice implements CollisionDevice {
  @Override
  public DeviceVoxels keep(BitCube voxels) {
    return new Voxels(voxels);
  }

  @Override
  public String name() {
    return "cpu";
  }

  @Override
  public Optional<String> failure() {
    return Optional.empty();
  }

  @Override
  public long batches() {
    return 0;
  }

  @Override
  public void close() {}

  private record Voxels(BitCube bits) implements DeviceVoxels {
    @Override
    public void voxelsChanged(IntBox box) {}

    @Override
    public LegBatch newBatch(PointSet points) {
      return new Legs(bits, points);
    }
  }

  private static final class Legs implements LegBatch {
    private final BitCube bits;
    private final PointSet points;
    private final MotionGroup motions = new MotionGroup();
    private final ExactRayCaster caster = new ExactRayCaster();
    private final Ray ray = new Ray();
    private final RayHit hit = new RayHit();

    Legs(BitCube bits, PointSet points) {
      this.bits = bits;
      this.points = points;
    }

    @Override
    public long crossover() {
      return NEVER;
    }

    @Override
    public int motionsAtOnce() {
      return 1;
    }

    @Override
    public boolean judge(MotionGroup newMotions) {
      motions.set(newMotions);
      return true;
    }

    @Override
    public LegVerdict verdict(int motion, int point) {
      AffineMap from = motions.from();
      AffineMap to = motions.to(motion);
      double x = points.x(point);
      double y = points.y(point);
      double z = points.z(point);
      ray.from(from.x(x, y, z), from.y(x, y, z), from.z(x, y, z));
      ray.to(to.x(x, y, z), to.y(x, y, z), to.z(x, y, z));
      return caster.cast(bits, ray, hit) ? LegVerdict.HIT : LegVerdict.FREE;
    }

    @Override
    public double emptyAround(int point) {
      AffineMap from = motions.from();
      double x = points.x(point);
      double y = points.y(point);
      double z = points.z(point);
      return EmptyCube.around(bits, from.x(x, y, z), from.y(x, y, z), from.z(x, y, z));
    }
  }
}
