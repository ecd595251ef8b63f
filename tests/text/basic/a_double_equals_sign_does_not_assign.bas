x==3 ' (expect alarm LB0004 at ==)
