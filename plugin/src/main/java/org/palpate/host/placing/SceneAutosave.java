package org.palpate.host.placing;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.palpate.body.BodyGroups;
import org.palpate.frame.PoseSnapshot;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SavedScene;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * Saves the bodies of a session from time to time while it runs, on a thread of its own, if
 * something changed. Poses are saved to the bit, so what was verified can be verified again.
 *
 * <p>One thread starts and closes it. After that, the caller may use the saved scene again.
 */
public final class SceneAutosave implements AutoCloseable {
  /** The time between two saves. */
  public static final long PERIOD_NANOS = 10_000_000_000L;

  /**
   * The most snapshots of poses for one save. Another one is needed if voxels changed after the
   * last one.
   */
  private static final int MOST_SNAPSHOTS = 20;

  /** The time between two checks whether a frame has copied the poses. */
  private static final long FRAME_WAIT_NANOS = 20_000_000;

  private final PlacedVolume start;
  private final boolean cuts;
  private final ToolFrame frame;
  private final SavedScene target;
  private final Consumer<IOException> failed;
  private final RepeatingThread thread;
  private volatile boolean closed;

  /** The poses that are saved, or with which the session began; empty before that. */
  private List<Pose> savedPoses = List.of();

  private BodyGroups savedGroups;

  /** The voxels to save: a copy if frames change them. */
  private final SegmentedVolume voxels;

  /** Whether the copy has changed since it was saved. */
  private boolean isCut;

  private boolean hasFailed;

  /**
   * Creates an autosave that does not run yet. Call it before the first frame.
   *
   * @param start the bodies of the session, whose voxels the frames change
   * @param cuts whether frames change voxels at all; only for bodies of one grid
   * @param frame gives poses, locks and groups; nobody else requests its poses
   * @param target receives the bodies; belongs to the autosave until that is closed
   * @param failed receives the first of failures in a row; on the thread of the autosave
   */
  public SceneAutosave(
      PlacedVolume start,
      boolean cuts,
      ToolFrame frame,
      SavedScene target,
      Consumer<IOException> failed) {
    this(start, cuts, frame, target, failed, PERIOD_NANOS);
  }

  /** Creates an autosave with another time between two saves. */
  SceneAutosave(
      PlacedVolume start,
      boolean cuts,
      ToolFrame frame,
      SavedScene target,
      Consumer<IOException> failed,
      long periodNanos) {
    this.start = start;
    this.cuts = cuts;
    this.frame = frame;
    this.target = target;
    this.failed = failed;
    voxels = cuts ? copy(start.rest()) : start.rest();
    thread = new RepeatingThread("palpate-autosave", periodNanos, this::tick, () -> {});
  }

  /** Starts to save. */
  public void start() {
    thread.start();
  }

  private void tick() {
    Optional<List<Pose>> poses = nextPoses();
    for (int n = 1; n < MOST_SNAPSHOTS && poses.isPresent() && takeChanges(); n++) {
      poses = nextPoses(); // a body may have left a place before it was filled
    }
    poses.ifPresent(left -> write(left, frame.groups()));
  }

  /** Waits for the poses that the next frame leaves; empty if the autosave is closed before. */
  private Optional<List<Pose>> nextPoses() {
    PoseSnapshot snapshot = frame.snapshot();
    snapshot.request();
    while (!snapshot.isReady()) {
      if (closed) {
        return Optional.empty();
      }
      LockSupport.parkNanos(this, FRAME_WAIT_NANOS);
    }
    return Optional.of(snapshot.poses());
  }

  /** Saves poses that a frame left, voxels, locks and groups, unless nothing changed. */
  synchronized void save(List<Pose> poses, BodyGroups groups) {
    if (!closed) {
      takeChanges();
    }
    write(poses, groups);
  }

  /** Saves poses and the voxels that were taken, locks and groups, unless nothing changed. */
  private synchronized void write(List<Pose> poses, BodyGroups groups) {
    if (closed) {
      return;
    }
    if (savedPoses.isEmpty()) {
      savedPoses = poses;
      savedGroups = groups;
    }
    if (!isCut && groups == savedGroups && haveSameBits(poses, savedPoses)) {
      return;
    }
    try {
      target.write(start.with(voxels).at(poses), isCut, groups);
      savedPoses = poses;
      savedGroups = groups;
      isCut = false;
      hasFailed = false;
    } catch (IOException e) {
      if (!hasFailed) {
        failed.accept(e);
      }
      hasFailed = true;
    }
  }

  private static SegmentedVolume copy(SegmentedVolume volume) {
    List<Segment> copies = new ArrayList<>();
    for (Segment segment : volume.segments()) {
      copies.add(new Segment(segment.name(), segment.bits().copy(), segment.rgb()));
    }
    return new SegmentedVolume(volume.grid(), copies, volume.grids());
  }

  /**
   * Takes the voxels that frames have changed, and returns whether there are any. A frame that has
   * copied poses has published all changes before; a later change of a brick is taken or not. If
   * there are none, the voxels are those among which the frame left the poses.
   */
  private synchronized boolean takeChanges() {
    boolean any = false;
    for (int n = 0; cuts && n < voxels.segments().size(); n++) {
      any |= takeChanges(start.rest().segments().get(n).bits(), voxels.segments().get(n).bits());
    }
    isCut |= any;
    return any;
  }

  private static boolean takeChanges(BitCube from, BitCube into) {
    boolean any = false;
    for (int z = 0; z < from.bricksZ(); z++) {
      for (int y = 0; y < from.bricksY(); y++) {
        for (int x = 0; x < from.bricksX(); x++) {
          long word = from.brick(x, y, z);
          if (word != into.brick(x, y, z)) {
            into.setBrick(x, y, z, word);
            any = true;
          }
        }
      }
    }
    return any;
  }

  private static boolean haveSameBits(List<Pose> one, List<Pose> other) {
    for (int n = 0; n < one.size(); n++) {
      if (!one.get(n).sameBits(other.get(n))) {
        return false;
      }
    }
    return true;
  }

  /** Ends the thread, after a save that has begun. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
    }
    thread.close();
  }
}
