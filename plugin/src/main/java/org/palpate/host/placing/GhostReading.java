package org.palpate.host.placing;

import java.util.ArrayList;
import java.util.List;
import org.palpate.fracture.fit.GhostDistance;
import org.palpate.geometry.Pose;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.fracture.PosedBits;

/**
 * The distances of a body from a ghost.
 *
 * @param ghost the name of the ghost
 * @param distance the distances
 */
public record GhostReading(String ghost, GhostDistance distance) {
  /**
   * {@return a reading for each ghost}
   *
   * @param body the body where it stands
   * @param ghosts the ghosts, which never move
   */
  public static List<GhostReading> of(PosedBits body, SegmentedVolume ghosts) {
    List<GhostReading> readings = new ArrayList<>();
    for (int n = 0; n < ghosts.segments().size(); n++) {
      Segment ghost = ghosts.segments().get(n);
      PosedBits there = new PosedBits(ghost.bits(), ghosts.grid(n), new Pose());
      readings.add(new GhostReading(ghost.name(), GhostDistance.read(body, there)));
    }
    return readings;
  }

  /**
   * {@return the line of the reading}
   *
   * @param body the name of the body
   */
  public String line(String body) {
    return body + " to " + ghost + ": " + ReadingText.of(distance);
  }
}
