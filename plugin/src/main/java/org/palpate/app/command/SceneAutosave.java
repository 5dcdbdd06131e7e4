package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.scene.OpenedScene;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.scene.SceneWriter;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Saves a scene with the present poses of its bodies from time to time, beside the scene file that
 * the session will write at its end. An orderly end deletes the saved file, so it remains only
 * after a crash. One thread.
 */
final class SceneAutosave {
  /** The time between two saves, if a body has moved meanwhile. */
  static final long PERIOD_NANOS = 10_000_000_000L;

  private static final String ENDING = ".json";

  private final OpenedScene scene;
  private final Path target;
  private final Supplier<List<RigidTransform>> poses;
  private List<RigidTransform> saved = List.of();
  private long lastNanos;

  /**
   * Prepares to save; the first save comes after a period.
   *
   * @param scene the scene of the session
   * @param target the file to write
   * @param poses gives the present pose of each body, from rest to present, world mm
   * @param nowNanos the present time
   */
  SceneAutosave(
      OpenedScene scene, Path target, Supplier<List<RigidTransform>> poses, long nowNanos) {
    this.scene = scene;
    this.target = target;
    this.poses = poses;
    lastNanos = nowNanos;
  }

  /**
   * Returns what saves a session; empty if it has no scene file or writes none at its end. A file
   * that an earlier session left is not replaced: the new one has a higher number.
   *
   * @param scene the scene file of the session
   * @param end the scene file that it will write
   * @throws VolumeFormatException if the scene cannot be read
   */
  static Optional<SceneAutosave> of(
      Optional<Path> scene, Optional<Path> end, Supplier<List<RigidTransform>> poses)
      throws VolumeFormatException {
    if (scene.isEmpty() || end.isEmpty()) {
      return Optional.empty();
    }
    Path target = beside(end.get(), 1 + left(end.get()).keySet().stream().reduce(0, Math::max));
    return Optional.of(
        new SceneAutosave(
            new OpenedScene(SceneReader.read(scene.get()), scene.get()),
            target,
            poses,
            System.nanoTime()));
  }

  private static Path beside(Path end, int number) {
    return end.resolveSibling(stem(end) + (number == 1 ? "" : number) + ENDING);
  }

  private static String stem(Path end) {
    String name = end.getFileName().toString();
    return (name.endsWith(ENDING) ? name.substring(0, name.length() - ENDING.length()) : name)
        + ".autosave";
  }

  /** Returns what sessions left beside the scene file that they did not write, by number. */
  private static SortedMap<Integer, Path> left(Path end) {
    Pattern name = Pattern.compile(Pattern.quote(stem(end)) + "([2-9]|[1-9]\\d{1,8}|)\\.json");
    SortedMap<Integer, Path> left = new TreeMap<>();
    String[] names = end.toAbsolutePath().getParent().toFile().list();
    for (String each : names == null ? new String[0] : names) {
      Matcher matcher = name.matcher(each);
      if (matcher.matches()) {
        String number = matcher.group(1);
        left.put(number.isEmpty() ? 1 : Integer.parseInt(number), end.resolveSibling(each));
      }
    }
    return left;
  }

  /**
   * Returns a note if an earlier session has crashed and left its saved file; empty otherwise, and
   * if the last of such files is the scene that is resumed.
   *
   * @param scene the scene file of the session
   * @param end the scene file that it will write
   */
  static Optional<String> note(Optional<Path> scene, Optional<Path> end) {
    SortedMap<Integer, Path> left = end.map(SceneAutosave::left).orElseGet(TreeMap::new);
    if (left.isEmpty()) {
      return Optional.empty();
    }
    Path last = left.get(left.lastKey());
    boolean resumes = scene.filter(file -> isSame(file, last)).isPresent();
    return resumes
        ? Optional.empty()
        : Optional.of(
            "A session did not end in order: --scene "
                + last
                + " resumes it. Delete that file once it is not needed.");
  }

  private static boolean isSame(Path one, Path other) {
    return one.toAbsolutePath().normalize().equals(other.toAbsolutePath().normalize());
  }

  /** Returns the file in which it saves. */
  Path target() {
    return target;
  }

  /**
   * Saves if a period is over, unless no body has moved since the last save.
   *
   * @throws IOException if the file cannot be written
   */
  void tick(long nowNanos) throws IOException {
    if (nowNanos - lastNanos < PERIOD_NANOS) {
      return;
    }
    lastNanos = nowNanos;
    List<RigidTransform> present = poses.get();
    if (!isSaved(present)) {
      try (AtomicFile file = new AtomicFile(target)) {
        List<Pose> restToPresent = present.stream().map(pose -> new Pose().set(pose)).toList();
        SceneWriter.write(scene.at(restToPresent, target), file.stream());
        file.commit();
      }
      saved = present;
    }
  }

  private boolean isSaved(List<RigidTransform> present) {
    boolean same = present.size() == saved.size();
    for (int n = 0; same && n < present.size(); n++) {
      same = present.get(n).sameBits(saved.get(n));
    }
    return same;
  }

  /**
   * Deletes what was saved, because the session has ended in order.
   *
   * @throws IOException if that is not possible
   */
  void end() throws IOException {
    if (!saved.isEmpty()) {
      Files.deleteIfExists(target);
    }
  }
}
