package org.palpate.imagej;

import org.palpate.imagej.session.CurrentSession;
import org.palpate.imagej.stack.TouchRefusedException;

/** "Stop Touching": ends the session as Escape does, and waits for its end. */
public final class StopTouching extends PalpateCommand {
  /** Creates the command; ImageJ calls this. */
  public StopTouching() {
    super("Stop Touching");
  }

  @Override
  void execute() throws TouchRefusedException {
    CurrentSession.stop();
  }
}
