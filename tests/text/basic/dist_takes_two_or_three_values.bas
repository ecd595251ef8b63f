x=dist(1) ' (expect alarm LB0017 at dist)
