x=1e308
y=x*10 ' (expect alarm LB0018 at *)
