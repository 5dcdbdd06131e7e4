package org.palpate.host;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/** The segments that a view draws at present. Any thread reads them. */
final class DrawnSolids {
  private final SegmentedVolume volume;
  private volatile List<Segment> segments;

  DrawnSolids(SegmentedVolume volume) {
    this.volume = volume;
    segments = volume.segments();
  }

  /** Returns the segments: the same list as long as none was replaced. */
  List<Segment> segments() {
    return segments;
  }

  /** Returns the volume before any replacement, with its grid. */
  SegmentedVolume volume() {
    return volume;
  }

  /** Replaces the voxels of a segment. */
  synchronized void replace(int segment, BitCube bits) {
    List<Segment> changed = new ArrayList<>(segments);
    Segment old = changed.get(segment);
    changed.set(segment, new Segment(old.name(), bits, old.rgb()));
    segments = List.copyOf(changed);
  }

  /**
   * Casts rays through the drawn voxels. One thread. It reads them without a lock, so a voxel that
   * changes meanwhile may count as it was.
   */
  static final class Probe {
    private final DrawnSolids solids;
    private final RayCaster caster = new ExactRayCaster();
    private final Ray ray = new Ray();
    private final RayHit hit = new RayHit();
    private List<Segment> segments = List.of();
    private CollisionScene scene = new CollisionScene(List.of());

    Probe(DrawnSolids solids) {
      this.solids = solids;
    }

    /** Takes the segments that are drawn now. */
    void refresh() {
      List<Segment> drawn = solids.segments();
      if (segments != drawn) {
        segments = drawn;
        scene = new CollisionScene(drawn.stream().map(Segment::bits).toList());
      }
    }

    /**
     * Returns where the ray between two points first meets a solid, as a fraction of its length.
     * Empty if it meets none or a point is not finite. Grid coordinates.
     */
    OptionalDouble firstHit(Vec3 from, Vec3 to) {
      boolean hits =
          from.isFinite()
              && to.isFinite()
              && scene.cast(caster, ray.from(from.x, from.y, from.z).to(to.x, to.y, to.z), hit);
      return hits ? OptionalDouble.of(hit.t) : OptionalDouble.empty();
    }

    /** Returns the name of the first segment that the ray between two points meets. */
    Optional<String> firstName(Vec3 from, Vec3 to) {
      int object = firstHit(from, to).isPresent() ? scene.objectAt(hit.i, hit.j, hit.k) : -1;
      return object < 0 ? Optional.empty() : Optional.of(segments.get(object).name());
    }

    /** Whether a voxel is solid. */
    boolean isSolid(int i, int j, int k) {
      return scene.isSolid(i, j, k);
    }
  }
}
