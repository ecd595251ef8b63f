for i to 3 ' (expect alarm LB0004 at to)
next
