power(1);speed(1)
circle(340,0,20) ' (expect alarm LB0019 at circle) (expect moves: none)
