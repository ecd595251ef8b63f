let wait=1 ' (expect alarm LB0005 at wait)
