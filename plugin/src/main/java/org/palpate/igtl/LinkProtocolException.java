package org.palpate.igtl;

import java.io.IOException;

/**
 * Reports a received message that breaks the OpenIGTLink protocol or exceeds a limit of this
 * program. Its text repeats no name from the message, because that could be a patient's.
 */
public final class LinkProtocolException extends IOException {
  private static final long serialVersionUID = 1;

  LinkProtocolException(String message) {
    super(message);
  }
}
