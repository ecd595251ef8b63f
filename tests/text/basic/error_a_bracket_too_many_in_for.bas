for i=1) to 3 ' (expect alarm LB0002 column 8)
next
