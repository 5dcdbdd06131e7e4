package org.palpate.host;

import java.util.List;
import org.palpate.collision.CollisionScene;
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

  /** Returns a new collision scene over the present segments, for one thread. */
  CollisionScene newScene() {
    return new CollisionScene(segments.stream().map(Segment::bits).toList());
  }
}
