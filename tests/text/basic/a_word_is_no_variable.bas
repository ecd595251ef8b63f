let to=3 ' (expect alarm LB0005 at to)
