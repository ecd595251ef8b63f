arc(10,0,6,0) ' (expect alarm LB0018 at arc)
