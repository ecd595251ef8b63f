x=sin(1,2) ' (expect alarm LB0017 at sin)
