for air=1 to 2 ' (expect alarm LB0005 at air)
next
