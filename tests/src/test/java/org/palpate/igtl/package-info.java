/** Runs the command {@code touch} with a client of its OpenIGTLink server. */
package org.palpate.igtl;
