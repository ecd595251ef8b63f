for i=1 to 3 step 0 ' (expect alarm LB0022 column 19 says STEP is zero)
next
