package org.palpate.imagej;

import ij.IJ;
import ij.ImagePlus;
import java.util.Locale;
import java.util.Optional;
import org.palpate.interaction.FrameRecorder;
import org.palpate.interaction.LoopEnd;

/**
 * "Touch Volume...": touches the stack in front until Escape, the end of its time, or the image
 * closes.
 */
public final class TouchVolume extends PalpateCommand {
  /** Made by ImageJ. */
  public TouchVolume() {
    super("Touch Volume");
  }

  @Override
  void execute() throws StackRefused {
    ImagePlus image = IJ.getImage();
    StackVolume volume = StackVolume.shownIn(image);
    if (volume.isOneOfSeveral() && !asksFor(volume)) {
      return;
    }
    TouchOptions options = TouchOptions.ask(volume);
    if (options != null) {
      touch(volume, options, Optional.empty());
    }
  }

  private static boolean asksFor(StackVolume volume) {
    return IJ.showMessageWithCancel(
        "Touch Volume",
        "The image has several channels or times.\nChannel "
            + volume.channel()
            + " at time "
            + volume.frame()
            + ", the one that is shown, will be touched.");
  }

  /** Runs a session to its end and says how it ended. */
  static void touch(StackVolume volume, TouchOptions options, Optional<FrameRecorder> recorder)
      throws StackRefused {
    Sessions.refuseSecond();
    try (StackSession session = new StackSession(volume, options, recorder)) {
      Sessions.begin(session);
      try {
        tell(session, session.run(options.seconds()));
      } finally {
        Sessions.end(session);
        CorrectSegment.forget();
      }
    }
  }

  private static void tell(StackSession session, LoopEnd end) throws StackRefused {
    IJ.showProgress(1);
    IJ.showStatus(
        String.format(
            Locale.ROOT,
            "Palpate: ended after %d frames, zero force sent",
            session.status().frames()));
    if (end.failure() != null) {
      throw new StackRefused("Touching ended by a failure: " + end.failure().getMessage());
    }
  }
}
