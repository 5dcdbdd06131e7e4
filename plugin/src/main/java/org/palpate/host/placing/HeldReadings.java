package org.palpate.host.placing;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.body.BodyGroups;
import org.palpate.fracture.PairReadings;
import org.palpate.fracture.Residual;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.io.file.NumberText;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.fracture.PosedBits;

/**
 * Reads how the fragment in hand fits its neighbours, and how far it has moved. Voxels are read
 * without a lock, so one that is cut meanwhile may count as it was. One thread.
 */
public final class HeldReadings {
  private final SegmentedVolume rest;
  private final List<Pose> starts;
  private final Optional<SegmentedVolume> ghosts;
  private final int reference;

  /**
   * Creates readings.
   *
   * @param rest the fragments at rest
   * @param starts the pose of each at the start
   * @param ghosts what the fragments are also read against, if there is any
   */
  public HeldReadings(SegmentedVolume rest, List<Pose> starts, Optional<SegmentedVolume> ghosts) {
    this.rest = rest;
    this.ghosts = ghosts;
    this.starts = starts;
    int largest = 0;
    for (int n = 0; n < rest.segments().size(); n++) {
      largest = voxels(n) > voxels(largest) ? n : largest;
    }
    reference = largest;
  }

  private long voxels(int n) {
    return rest.segments().get(n).bits().solidCount();
  }

  /**
   * {@return the line above the readings of a fragment}
   *
   * @param fragment the index of the fragment
   * @param isHeld whether it is in hand; otherwise the hand touched it last
   */
  public String heading(int fragment, boolean isHeld) {
    return (isHeld ? "in hand: " : "touched last: ") + name(fragment);
  }

  /**
   * {@return a line for each fragment that one faces, one for each ghost, and a line about its
   * motion since the start} If it did not start where it rests, there is a line about its distance
   * from there, relative to the largest fragment. Some hundred milliseconds for fragments of 10,000
   * voxels.
   *
   * @param fragment the index of the fragment in hand
   * @param poses the present pose of each fragment, from rest to present, world mm
   * @param groups fragments that move together with it are left out
   */
  public List<String> lines(int fragment, List<RigidTransform> poses, BodyGroups groups) {
    List<String> lines = new ArrayList<>();
    PosedBits own = posed(fragment, poses);
    for (int other = 0; other < poses.size(); other++) {
      if (!groups.moveTogether(fragment, other)) {
        PairReadings read = PairReadings.read(own, posed(other, poses));
        if (read.isFacing()) {
          String overlap = "; overlap " + NumberText.count((double) read.overlapVoxels());
          lines.add(name(fragment) + " to " + name(other) + ": " + ReadingText.of(read) + overlap);
        }
      }
    }
    ghosts.ifPresent(
        faint -> GhostReading.of(own, faint).forEach(each -> lines.add(each.line(name(fragment)))));
    lines.add(
        name(fragment) + ": moved " + ReadingText.of(Residual.since(starts.get(fragment), own)));
    if (fragment != reference && !starts.get(fragment).sameBits(new Pose())) {
      Pose base = posed(reference, poses).pose();
      lines.add(
          name(fragment) + ": from where it rests " + ReadingText.of(Residual.fromRest(own, base)));
    }
    return lines;
  }

  private PosedBits posed(int n, List<RigidTransform> poses) {
    return new PosedBits(segment(n).bits(), rest.grid(n), new Pose().set(poses.get(n)));
  }

  private Segment segment(int n) {
    return rest.segments().get(n);
  }

  private String name(int n) {
    return segment(n).name();
  }
}
