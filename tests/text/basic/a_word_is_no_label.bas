line: x=1 ' (expect alarm LB0001 at :)
