package org.palpate.assess;

import org.palpate.frame.FrameRecord;

/**
 * The contacts with one object: how often, how long, and with which force. A frame counts for the
 * time since the frame before. One thread.
 */
public final class ContactStatistics {
  private double share;
  private boolean isTouching;
  private long contacts;
  private double seconds;
  private double impulseNewtonSeconds;
  private double largestNewton;
  private double largestAtSeconds;

  ContactStatistics() {}

  /** Begins a frame in which the object is not touched, as far as is known. */
  void begin() {
    share = 0;
  }

  /** Adds the share of a contact with the object. */
  void add(double ofContact) {
    share += ofContact;
  }

  /** Ends the frame. */
  void end(FrameRecord frame, double atSeconds, double elapsedSeconds) {
    boolean touches = share > 0;
    contacts += touches && !isTouching ? 1 : 0;
    isTouching = touches;
    double newton = share * frame.pressingNewton;
    if (touches) {
      seconds += elapsedSeconds;
      impulseNewtonSeconds += newton * elapsedSeconds;
    }
    if (newton > largestNewton) {
      largestNewton = newton;
      largestAtSeconds = atSeconds;
    }
  }

  /** Whether the last frame touched the object. */
  boolean isTouching() {
    return isTouching;
  }

  /** {@return how often the object was touched anew} */
  public long contacts() {
    return contacts;
  }

  /** {@return how long the object was touched, s} */
  public double seconds() {
    return seconds;
  }

  /** {@return the mean force while the object was touched, N; 0 if it never was} */
  public double meanNewton() {
    return seconds > 0 ? impulseNewtonSeconds / seconds : 0;
  }

  /** {@return the largest force on the object, N} */
  public double largestNewton() {
    return largestNewton;
  }

  /** {@return the time of the largest force, s} */
  public double largestAtSeconds() {
    return largestAtSeconds;
  }
}
