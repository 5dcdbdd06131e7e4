package org.palpate.host;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.file.NumberText;
import org.palpate.io.table.CsvWriter;
import org.palpate.io.table.EditsCsv;
import org.palpate.recording.EditRecorder;
import org.palpate.recording.RecordingThread;
import org.palpate.recording.SampleRecorder;
import org.palpate.recording.TrajectoryWriter;

/**
 * Records what a device sends into a trajectory file that can be replayed.
 *
 * <p>Opened, finished and closed by one thread at a time. A thread of its own takes the samples
 * from the haptic thread and writes them.
 */
public final class TrajectoryRecording implements AutoCloseable {
  private final Path target;
  private final AtomicFile file;
  private final Writer writer;
  private final SampleRecorder recorder = new SampleRecorder();
  private final EditRecorder editRecorder = new EditRecorder();
  private final List<String> segments;

  /** The file of edits, from the first edit on; belongs to the recording thread until it ends. */
  private AtomicFile editsFile;

  private CsvWriter editRows;
  private final RecordingThread thread;

  /** Written by the recording thread alone. */
  private volatile boolean holdsSamples;

  /**
   * Starts a recording of samples alone.
   *
   * @throws IOException if the file cannot be created
   */
  public TrajectoryRecording(Path target) throws IOException {
    this(target, List.of());
  }

  /**
   * Starts a recording. Changes of voxels go into a second file, {@code T.edits.csv} beside {@code
   * T.csv}, if there are any.
   *
   * @param segments names of the segments, in the order of their indices
   * @throws IOException if the file cannot be created
   */
  public TrajectoryRecording(Path target, List<String> segments) throws IOException {
    this.target = target;
    this.segments = List.copyOf(segments);
    file = new AtomicFile(target);
    writer = new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8);
    TrajectoryWriter rows = new TrajectoryWriter(writer, NumberText::text);
    thread =
        RecordingThread.start(
            recorder,
            (sample, flags) -> {
              holdsSamples = true;
              rows.accept(sample, flags);
            },
            () -> editRecorder.drainTo(this::writeEdit));
  }

  private void writeEdit(long sample, int segment, int i, int j, int k, boolean solid) {
    try {
      if (editsFile == null) {
        editsFile = new AtomicFile(editsFile(target));
        editRows = EditsCsv.writer(editsFile.stream());
      }
      EditsCsv.add(editRows, sample, segments.get(segment), i, j, k, solid);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the table of edits that belongs to a recording: {@code T.edits.csv}. */
  public static Path editsFile(Path recording) {
    return table(recording, ".edits.csv");
  }

  /** Returns the table of poses that belongs to a recording: {@code T.poses.csv}. */
  public static Path posesFile(Path recording) {
    return table(recording, ".poses.csv");
  }

  private static Path table(Path recording, String ending) {
    String name = recording.getFileName().toString();
    String stem = name.endsWith(".csv") ? name.substring(0, name.length() - 4) : name;
    return recording.resolveSibling(stem + ending);
  }

  /** Returns why the recording cannot be written, as far as is known. Any thread. */
  public Optional<IOException> failure() {
    return thread.failure() instanceof UncheckedIOException e
        ? Optional.of(e.getCause())
        : Optional.empty();
  }

  /** Returns the file that the recording replaces when it is finished. */
  public Path target() {
    return target;
  }

  /** Returns the recorder to give to a {@link TouchSession}. */
  public SampleRecorder recorder() {
    return recorder;
  }

  /** Returns the recorder of the changes of voxels, to give to a {@link TouchSession}. */
  public EditRecorder editRecorder() {
    return editRecorder;
  }

  /**
   * Writes the remaining samples and moves the file over its target, unless there is no sample at
   * all. Call it after the session's last frame. If nothing was edited, an older table of edits is
   * deleted, because it would not fit the new samples.
   *
   * @throws IOException if the file cannot be written
   */
  public void finish() throws IOException {
    try {
      thread.close();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    writer.flush();
    if (holdsSamples) {
      file.commit();
    }
    if (editsFile != null) {
      editsFile.stream().flush();
      editsFile.commit();
    } else if (holdsSamples) {
      Files.deleteIfExists(editsFile(target));
    }
    if (editRecorder.overflows() > 0) {
      throw new IOException(
          editRecorder.overflows() + " changes of voxels were lost; a replay would differ");
    }
  }

  /** Ends the recording; without {@link #finish} no file remains. May be called repeatedly. */
  @Override
  public void close() {
    try {
      closeBoth();
    } catch (IOException | UncheckedIOException e) {
      // The recording is given up; finish has reported the reason if the file was wanted.
    }
  }

  private void closeBoth() throws IOException {
    try {
      thread.close();
    } finally {
      file.close();
      if (editsFile != null) {
        editsFile.close();
      }
    }
  }
}
