input 5 ' (expect alarm LB0005 at 5)
