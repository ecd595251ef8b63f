for 3=1 to 2 ' (expect alarm LB0005 column 5 says not a variable)
next
