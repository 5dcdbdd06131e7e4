package org.palpate.igtl;

import java.io.IOException;

/** A message that breaks the protocol or a bound of this program. The message text has no name. */
public final class LinkProtocolException extends IOException {
  private static final long serialVersionUID = 1;

  LinkProtocolException(String message) {
    super(message);
  }
}
