package org.palpate.igtl;

/** Receives what clients send. The methods run on the thread of a client. */
public interface LinkListener {
  /**
   * Receives an image to touch.
   *
   * @return an empty text if it is accepted, else the reason, which the client gets as a status
   */
  String received(ReceivedImage image);

  /** Prints a line for the user. */
  void print(String line);
}
