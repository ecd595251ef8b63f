power(1);speed(1)
move(340,0)
arc(340,100,60,1) ' (expect alarm LB0019 at arc) (expect moves: none)
