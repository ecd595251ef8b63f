for i=1 to 3 ' (expect alarm LB0014 column 1 says FOR without NEXT)
print i
