package org.palpate.igtl;

/** Receives what clients send. The methods run on the thread of a client. */
public interface LinkListener {
  /**
   * Receives an image to touch.
   *
   * @return an empty text if it is accepted, else the reason, which the client gets as a status
   */
  String received(ReceivedImage image);

  /**
   * Receives a pose, which belongs to the body of its name.
   *
   * @return an empty text if it is accepted or there is no such body, else the reason, which the
   *     client gets as a status
   */
  String received(ReceivedTransform transform);

  /** Prints a line for the user. */
  void print(String line);
}
