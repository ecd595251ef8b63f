' (run with: --param statement_limit=100000)
for c0=1 to 1
for c1=1 to 1
for c2=1 to 1
for c3=1 to 1
for c4=1 to 1
for c5=1 to 1
for c6=1 to 1
for c7=1 to 1
for c8=1 to 1
for c9=1 to 1
for c10=1 to 1
for c11=1 to 1
for c12=1 to 1
for c13=1 to 1
for c14=1 to 1
for c15=1 to 1
for c16=1 to 1
for c17=1 to 1
for c18=1 to 1
for c19=1 to 1
for c20=1 to 1
for c21=1 to 1
for c22=1 to 1
for c23=1 to 1
for c24=1 to 1
for c25=1 to 1
for c26=1 to 1
for c27=1 to 1
for c28=1 to 1
for c29=1 to 1
for c30=1 to 1
for c31=1 to 1
for c32=1 to 1
for c33=1 to 1
for c34=1 to 1
for c35=1 to 1
for c36=1 to 1
for c37=1 to 1
for c38=1 to 1
for c39=1 to 1
for c40=1 to 1
for c41=1 to 1
for c42=1 to 1
for c43=1 to 1
for c44=1 to 1
for c45=1 to 1
for c46=1 to 1
for c47=1 to 1
for c48=1 to 1
for c49=1 to 1
for c50=1 to 1
for c51=1 to 1
for c52=1 to 1
for c53=1 to 1
for c54=1 to 1
for c55=1 to 1
for c56=1 to 1
for c57=1 to 1
for c58=1 to 1
for c59=1 to 1
for c60=1 to 1
for c61=1 to 1
for c62=1 to 1
for c63=1 to 1
for c64=1 to 1
for c65=1 to 1
for c66=1 to 1
for c67=1 to 1
for c68=1 to 1
for c69=1 to 1
for c70=1 to 1
for c71=1 to 1
for c72=1 to 1
for c73=1 to 1
for c74=1 to 1
for c75=1 to 1
for c76=1 to 1
for c77=1 to 1
for c78=1 to 1
for c79=1 to 1
for c80=1 to 1
for c81=1 to 1
for c82=1 to 1
for c83=1 to 1
for c84=1 to 1
for c85=1 to 1
for c86=1 to 1
for c87=1 to 1
for c88=1 to 1
for c89=1 to 1
for c90=1 to 1
for c91=1 to 1
for c92=1 to 1
for c93=1 to 1
for c94=1 to 1
for c95=1 to 1
for c96=1 to 1
for c97=1 to 1
for c98=1 to 1
for c99=1 to 1
for c100=1 to 1
for c101=1 to 1
for c102=1 to 1
for c103=1 to 1
for c104=1 to 1
for c105=1 to 1
for c106=1 to 1
for c107=1 to 1
for c108=1 to 1
for c109=1 to 1
for c110=1 to 1
for c111=1 to 1
for c112=1 to 1
for c113=1 to 1
for c114=1 to 1
for c115=1 to 1
for c116=1 to 1
for c117=1 to 1
for c118=1 to 1
for c119=1 to 1
for c120=1 to 1
for c121=1 to 1
for c122=1 to 1
for c123=1 to 1
for c124=1 to 1
for c125=1 to 1
for c126=1 to 1
for c127=1 to 1
for c128=1 to 1
for c129=1 to 1
for c130=1 to 1
for c131=1 to 1
for c132=1 to 1
for c133=1 to 1
for c134=1 to 1
for c135=1 to 1
for c136=1 to 1
for c137=1 to 1
for c138=1 to 1
for c139=1 to 1
for c140=1 to 1
for c141=1 to 1
for c142=1 to 1
for c143=1 to 1
for c144=1 to 1
for c145=1 to 1
for c146=1 to 1
for c147=1 to 1
for c148=1 to 1
for c149=1 to 1
for c150=1 to 1
for c151=1 to 1
for c152=1 to 1
for c153=1 to 1
for c154=1 to 1
for c155=1 to 1
for c156=1 to 1
for c157=1 to 1
for c158=1 to 1
for c159=1 to 1
for c160=1 to 1
for c161=1 to 1
for c162=1 to 1
for c163=1 to 1
for c164=1 to 1
for c165=1 to 1
for c166=1 to 1
for c167=1 to 1
for c168=1 to 1
for c169=1 to 1
for c170=1 to 1
for c171=1 to 1
for c172=1 to 1
for c173=1 to 1
for c174=1 to 1
for c175=1 to 1
for c176=1 to 1
for c177=1 to 1
for c178=1 to 1
for c179=1 to 1
for c180=1 to 1
for c181=1 to 1
for c182=1 to 1
for c183=1 to 1
for c184=1 to 1
for c185=1 to 1
for c186=1 to 1
for c187=1 to 1
for c188=1 to 1
for c189=1 to 1
for c190=1 to 1
for c191=1 to 1
for c192=1 to 1
for c193=1 to 1
for c194=1 to 1
for c195=1 to 1
for c196=1 to 1
for c197=1 to 1
for c198=1 to 1
for c199=1 to 1
for c200=1 to 1
for c201=1 to 1
for c202=1 to 1
for c203=1 to 1
for c204=1 to 1
for c205=1 to 1
for c206=1 to 1
for c207=1 to 1
for c208=1 to 1
for c209=1 to 1
for c210=1 to 1
for c211=1 to 1
for c212=1 to 1
for c213=1 to 1
for c214=1 to 1
for c215=1 to 1
for c216=1 to 1
for c217=1 to 1
for c218=1 to 1
for c219=1 to 1
for c220=1 to 1
for c221=1 to 1
for c222=1 to 1
for c223=1 to 1
for c224=1 to 1
for c225=1 to 1
for c226=1 to 1
for c227=1 to 1
for c228=1 to 1
for c229=1 to 1
for c230=1 to 1
for c231=1 to 1
for c232=1 to 1
for c233=1 to 1
for c234=1 to 1
for c235=1 to 1
for c236=1 to 1
for c237=1 to 1
for c238=1 to 1
for c239=1 to 1
for c240=1 to 1
for c241=1 to 1
for c242=1 to 1
for c243=1 to 1
for c244=1 to 1
for c245=1 to 1
for c246=1 to 1
for c247=1 to 1
for c248=1 to 1
for c249=1 to 1
for c250=1 to 1
for c251=1 to 1
for c252=1 to 1
for c253=1 to 1
for c254=1 to 1
for c255=1 to 1
for c256=1 to 1 ' (expect alarm LB0010 at for)
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
next
