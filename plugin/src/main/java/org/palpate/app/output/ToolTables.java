package org.palpate.app.output;

import java.io.IOException;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.palpate.app.options.NumberRange;
import org.palpate.app.process.PalpateException;
import org.palpate.device.DeviceState;
import org.palpate.device.Trajectory;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.host.ToolLegs;
import org.palpate.host.ToolReplay;
import org.palpate.host.ToolScene;
import org.palpate.io.table.ToolFramesCsvWriter;
import org.palpate.io.table.ToolLegsCsvWriter;

/** The tables that a replay of a rigid tool writes, each only if it was asked for. One thread. */
public final class ToolTables implements ToolReplay.FrameSink {
  private final Trajectory trajectory;
  private final Optional<ToolFramesCsvWriter> frames;
  private final Optional<ToolLegsCsvWriter> legs;
  private final LegSelection selection;
  private final ReplayTables tables;
  private final ToolLegs list;
  private final Pose device = new Pose();

  /** Whether a body was held, so that the tool begins new chains of legs when it returns. */
  private boolean wasHolding;

  /**
   * The legs to write.
   *
   * @param every only points whose index is divisible by this, at least 1
   * @param first the first frame, counted from 0
   * @param last the last frame
   */
  public record LegSelection(int every, long first, long last) {
    private static final NumberRange EVERY =
        new NumberRange("--legs-every", "the number", 1, Integer.MAX_VALUE, "", "10");

    private static final Pattern FRAMES =
        Pattern.compile("\\s*([0-9]{1,18})\\s*\\.\\.\\s*([0-9]{1,18})\\s*");

    /** Every leg. */
    public static final LegSelection ALL = new LegSelection(1, 0, Long.MAX_VALUE);

    /**
     * Parses the values of the options; null for one that was not given.
     *
     * @throws PalpateException exit code 2, if a value is not understood
     */
    public static LegSelection parse(Integer every, String range) {
      EVERY.checkGiven(every);
      int some = every == null ? ALL.every : every;
      return range == null ? new LegSelection(some, ALL.first, ALL.last) : frames(some, range);
    }

    private static LegSelection frames(int every, String range) {
      Matcher ends = FRAMES.matcher(range);
      if (!ends.matches() || Long.parseLong(ends.group(1)) > Long.parseLong(ends.group(2))) {
        throw PalpateException.wrongUse(
            "a range of frames is needed",
            "--legs-frames " + range,
            "write A..B with the first and the last frame, as in --legs-frames 0..999");
      }
      return new LegSelection(every, Long.parseLong(ends.group(1)), Long.parseLong(ends.group(2)));
    }

    private boolean contains(int frame) {
      return frame >= first && frame <= last;
    }
  }

  /**
   * Makes the tables. {@link ReplayTables} opens and commits their files.
   *
   * @param selection the legs to write
   * @param frames the rows of frames, if they are wanted
   * @param legs the rows of legs, if they are wanted
   * @param tables the files
   */
  ToolTables(
      Trajectory trajectory,
      ToolScene scene,
      LegSelection selection,
      Optional<ToolFramesCsvWriter> frames,
      Optional<ToolLegsCsvWriter> legs,
      ReplayTables tables) {
    this.tables = tables;
    this.trajectory = trajectory;
    this.selection = selection;
    this.frames = frames;
    this.legs = legs;
    list = new ToolLegs(scene.bodies(), scene.tool());
  }

  @Override
  public void accept(int number, ToolFrame frame) {
    frames.ifPresent(rows -> tables.toFrames(() -> addFrame(rows, number, frame)));
    boolean holds = frame.heldBody() >= 0;
    boolean beginsAnew = frame.wasFreed() || wasHolding;
    if (selection.contains(number) && !holds) {
      legs.ifPresent(rows -> tables.toLegs(() -> addLegs(rows, number, frame, beginsAnew)));
    }
    wasHolding = holds;
  }

  private void addLegs(ToolLegsCsvWriter rows, int number, ToolFrame frame, boolean beginsAnew)
      throws IOException {
    list.list(
        frame.motion(),
        beginsAnew,
        selection.every(),
        (leg, body, point, start, end) -> rows.add(number, leg, body, point, start, end));
  }

  private void addFrame(ToolFramesCsvWriter rows, int number, ToolFrame frame) throws IOException {
    DeviceState sample = frame.sample();
    rows.add(
        number,
        trajectory.timeMs(number),
        device.set(sample.positionMm, sample.orientation),
        frame.motion().pose(),
        frame.forceNewton(),
        frame.torqueNewtonMm(),
        frame.motion().contact(),
        list.longestPathMm(frame.motion(), frame.shape()));
  }
}
