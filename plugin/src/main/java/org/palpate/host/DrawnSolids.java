package org.palpate.host;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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

  /** Returns the volume as it was at first, with its grid. */
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

  /** Returns a new collision scene over the present segments, for one thread. */
  CollisionScene newScene() {
    return new CollisionScene(segments.stream().map(Segment::bits).toList());
  }

  /**
   * Finds the segment that the interaction point touches: the first on the way to the device. One
   * thread. It reads the drawn voxels without a lock, so it may be a tick behind an edit.
   */
  static final class TouchedSegment {
    private final DrawnSolids solids;
    private final RayCaster caster = new ExactRayCaster();
    private final Ray ray = new Ray();
    private final RayHit hit = new RayHit();
    private List<Segment> segments = List.of();
    private CollisionScene scene = new CollisionScene(List.of());

    TouchedSegment(DrawnSolids solids) {
      this.solids = solids;
    }

    /** Returns the name of the segment between a point in contact and the device. */
    Optional<String> name(Vec3 pointGrid, Vec3 deviceGrid) {
      if (segments != solids.segments()) {
        segments = solids.segments();
        scene = solids.newScene();
      }
      ray.from(pointGrid.x, pointGrid.y, pointGrid.z).to(deviceGrid.x, deviceGrid.y, deviceGrid.z);
      boolean hits = pointGrid.isFinite() && deviceGrid.isFinite() && scene.cast(caster, ray, hit);
      int object = hits ? scene.objectAt(hit.i, hit.j, hit.k) : -1;
      return object < 0 ? Optional.empty() : Optional.of(segments.get(object).name());
    }
  }
}
