local 3 ' (expect alarm LB0005 at 3)
