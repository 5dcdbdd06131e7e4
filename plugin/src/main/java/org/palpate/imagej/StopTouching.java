package org.palpate.imagej;

/** "Stop Touching": ends the session as Escape does, and waits for its end. */
public final class StopTouching extends PalpateCommand {
  /** Made by ImageJ. */
  public StopTouching() {
    super("Stop Touching");
  }

  @Override
  void execute() throws StackRefused {
    Sessions.stop();
  }
}
