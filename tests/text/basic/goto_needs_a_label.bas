goto "x" ' (expect alarm LB0001 at "x")
