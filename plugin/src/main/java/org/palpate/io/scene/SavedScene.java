package org.palpate.io.scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.palpate.body.BodyGroups;
import org.palpate.io.VolumeWriter;
import org.palpate.io.file.FileClaim;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.table.GroupsCsv;

/**
 * A scene file that a session replaces again and again while it runs. If no files hold the voxels
 * of the bodies as they are, a label volume beside it does. A table beside it holds locks and
 * groups, if there are any. One thread at a time.
 */
public final class SavedScene implements AutoCloseable {
  private final Path file;
  private final Path volume;
  private final FileClaim claim;
  private boolean isWritten;
  private boolean hasVolume;

  SavedScene(Path file, Path volume, FileClaim claim) {
    this.file = file;
    this.volume = volume;
    this.claim = claim;
  }

  /** Returns the scene file. */
  public Path file() {
    return file;
  }

  /** Whether there is something to resume. */
  public boolean isWritten() {
    return isWritten;
  }

  /**
   * Replaces the scene file. A body without a voxel, which was cut away, is left out, because no
   * scene with it can be read.
   *
   * @param bodies the bodies where they are; nobody edits their voxels meanwhile
   * @param cut whether voxels changed after the last call, or after the session began
   * @param groups locks and groups of the bodies, which get a table of their own
   * @throws IOException if a file cannot be written; then the last one stays
   * @throws IllegalArgumentException if voxels changed and the bodies have several grids
   */
  public void write(PlacedVolume bodies, boolean cut, BodyGroups groups) throws IOException {
    List<Integer> solid = bodies.solid();
    boolean isWhole = solid.isEmpty() || solid.size() == bodies.placements().size();
    if (isWhole) {
      replace(bodies, cut, groups);
    } else {
      replace(bodies.only(solid), cut, only(solid, groups));
    }
  }

  private void replace(PlacedVolume bodies, boolean cut, BodyGroups groups) throws IOException {
    if (cut || (!hasVolume && bodies.origin().isEmpty())) {
      VolumeWriter.write(new SegmentsAsLabels(bodies.rest(), bodies.world()), volume);
      hasVolume = true;
    }
    SceneFile scene =
        hasVolume
            ? bodies.sceneOfLabels(volume.getFileName().toString(), file)
            : bodies.sceneOfFiles(file);
    SceneWriter.replace(file, scene, bodies.names(), groups);
    isWritten = true;
  }

  /** Returns the locks and groups of some bodies alone, by their numbers. */
  private static BodyGroups only(List<Integer> kept, BodyGroups groups) {
    BodyGroups only = BodyGroups.none(kept.size());
    for (int n = 0; n < kept.size(); n++) {
      for (int m = 0; m < n; m++) {
        only = groups.moveTogether(kept.get(m), kept.get(n)) ? only.bound(m, n) : only;
      }
    }
    for (int n = 0; n < kept.size(); n++) {
      only = groups.isLocked(kept.get(n)) ? only.withLock(n, true) : only;
    }
    return only;
  }

  /**
   * Deletes what was written, because the session does not need it any more.
   *
   * @throws IOException if that is not possible
   */
  public void delete() throws IOException {
    Files.deleteIfExists(GroupsCsv.beside(file));
    if (isWritten) {
      Files.deleteIfExists(file);
    }
    if (hasVolume) {
      Files.deleteIfExists(volume);
    }
    isWritten = false;
    hasVolume = false;
  }

  /** Gives the name back, so that the next session sees what was left under it. */
  @Override
  public void close() throws IOException {
    claim.close();
  }
}
