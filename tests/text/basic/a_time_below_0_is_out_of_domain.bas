power(50)
burn(-1) ' (expect alarm LB0018 says a time is 0 to 99999.999 s)
