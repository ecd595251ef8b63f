a=1b=2
c=3
d=a+b+cprint d ' (expect d=6)
x=$ ' (expect alarm LB0026 at $)