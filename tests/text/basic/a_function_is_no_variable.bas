sin=3 ' (expect alarm LB0001 at sin)
