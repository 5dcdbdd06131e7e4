package org.palpate.host;

import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.palpate.body.BodyEvent;
import org.palpate.elastic.RecordedUpdate;
import org.palpate.geometry.Pose;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.file.NumberText;
import org.palpate.io.table.CsvWriter;
import org.palpate.io.table.EditsCsv;
import org.palpate.io.table.FieldsCsv;
import org.palpate.io.table.PosesCsv;
import org.palpate.recording.BodyRecorder;
import org.palpate.recording.EditRecorder;
import org.palpate.recording.FieldRecorder;
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
  private final BodyRecorder bodyRecorder = new BodyRecorder();
  private final FieldRecorder fieldRecorder = new FieldRecorder();
  private final List<String> segments;
  private final SecondTable edits;
  private final SecondTable poses;
  private final SecondTable fields;
  private final RecordingThread thread;

  /** Written by the recording thread alone. */
  private volatile boolean holdsSamples;

  /**
   * A table beside the samples, made for its first row. Belongs to the recording thread until that
   * ends.
   */
  private static final class SecondTable {
    private final Path target;
    private AtomicFile file;
    private CsvWriter rows;

    private SecondTable(Path target) {
      this.target = target;
    }

    /** Begins the table. */
    private interface Begin {
      CsvWriter begin(OutputStream stream) throws IOException;
    }

    /** Adds a row. */
    private interface Row {
      void add(CsvWriter rows) throws IOException;
    }

    private void add(Begin begin, Row row) {
      try {
        if (file == null) {
          file = new AtomicFile(target);
          rows = begin.begin(file.stream());
        }
        row.add(rows);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    /** Moves the table over its target; an older one does not fit the new samples. */
    private void finish() throws IOException {
      if (file != null) {
        file.stream().flush();
        file.commit();
      } else {
        Files.deleteIfExists(target);
      }
    }

    private void close() throws IOException {
      if (file != null) {
        file.close();
      }
    }
  }

  /**
   * Starts a recording of samples alone.
   *
   * @param target the file to write, which is replaced when the recording is finished
   * @throws IOException if the file cannot be created
   */
  public TrajectoryRecording(Path target) throws IOException {
    this(target, List.of());
  }

  /**
   * Starts a recording. Changes of voxels go into {@code T.edits.csv} beside {@code T.csv}, and
   * poses of bodies into {@code T.poses.csv}, and updates of elastic segments into {@code
   * T.fields.csv}, if there are any.
   *
   * @param target the file to write, which is replaced when the recording is finished
   * @param segments names of the segments and bodies, in the order of their indices
   * @throws IOException if the file cannot be created
   */
  public TrajectoryRecording(Path target, List<String> segments) throws IOException {
    this.target = target;
    this.segments = List.copyOf(segments);
    edits = new SecondTable(editsFile(target));
    poses = new SecondTable(posesFile(target));
    fields = new SecondTable(fieldsFile(target));
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
            () -> {
              editRecorder.drainTo(this::writeEdit);
              bodyRecorder.drainTo(this::writePose);
              fieldRecorder.drainTo(this::writeUpdate);
            });
  }

  private void writeEdit(long sample, int segment, int i, int j, int k, boolean solid) {
    String name = segments.get(segment);
    edits.add(EditsCsv::writer, rows -> EditsCsv.add(rows, sample, name, i, j, k, solid));
  }

  private void writePose(long sample, int body, BodyEvent event, Pose pose, Pose inHand) {
    String name = segments.get(body);
    poses.add(PosesCsv::writer, rows -> PosesCsv.add(rows, sample, name, event, pose, inHand));
  }

  private void writeUpdate(RecordedUpdate update) {
    fields.add(FieldsCsv::writer, rows -> FieldsCsv.add(rows, update));
  }

  /**
   * {@return the table of edits that belongs to a recording: {@code T.edits.csv}}
   *
   * @param recording the file of the samples, {@code T.csv}
   */
  public static Path editsFile(Path recording) {
    return table(recording, ".edits.csv");
  }

  /**
   * {@return the table of poses that belongs to a recording: {@code T.poses.csv}}
   *
   * @param recording the file of the samples, {@code T.csv}
   */
  public static Path posesFile(Path recording) {
    return table(recording, ".poses.csv");
  }

  /**
   * {@return the table of updates that belongs to a recording: {@code T.fields.csv}}
   *
   * @param recording the file of the samples, {@code T.csv}
   */
  public static Path fieldsFile(Path recording) {
    return table(recording, ".fields.csv");
  }

  private static Path table(Path recording, String ending) {
    String name = recording.getFileName().toString();
    String stem = name.endsWith(".csv") ? name.substring(0, name.length() - 4) : name;
    return recording.resolveSibling(stem + ending);
  }

  /** {@return why the recording cannot be written, as far as is known} Any thread. */
  public Optional<IOException> failure() {
    return thread.failure() instanceof UncheckedIOException e
        ? Optional.of(e.getCause())
        : Optional.empty();
  }

  /** {@return the file that the recording replaces when it is finished} */
  public Path target() {
    return target;
  }

  /** {@return the recorder to give to a {@link TouchSession}} */
  public SampleRecorder recorder() {
    return recorder;
  }

  /** {@return the recorder of the changes of voxels, to give to a {@link TouchSession}} */
  public EditRecorder editRecorder() {
    return editRecorder;
  }

  /** {@return the recorder of the poses of bodies, to give to a {@link TouchSession}} */
  public BodyRecorder bodyRecorder() {
    return bodyRecorder;
  }

  /** {@return the recorder of updates of elastic segments, to give to a {@link TouchSession}} */
  public FieldRecorder fieldRecorder() {
    return fieldRecorder;
  }

  /**
   * Writes the remaining samples and moves the files over their targets. If there is no sample at
   * all, older files stay. Call it after the session's last frame. If nothing was edited, no body
   * moved or no update was recorded, an older table of these is deleted, because it would not fit
   * the new samples.
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
      edits.finish();
      poses.finish();
      fields.finish();
    }
    requireWhole("changes of voxels", editRecorder.overflows());
    requireWhole("poses of bodies", bodyRecorder.overflows());
    requireWhole("updates of elastic segments", fieldRecorder.overflows());
  }

  private static void requireWhole(String what, long lost) throws IOException {
    if (lost > 0) {
      throw new IOException(lost + " " + what + " were lost; a replay would differ");
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
      edits.close();
      poses.close();
      fields.close();
    }
  }
}
